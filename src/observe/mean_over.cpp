#include "observe/mean_over.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace tumble::observe {

Rows rows_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
               double every) {
    Rows rows;
    std::size_t all = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] > from + every / 2 && times[i] <= until + every / 2) {
            ++all;
            if (std::isfinite(values[i])) {
                rows.time.push_back(times[i]);
                rows.value.push_back(values[i]);
            }
        }
    return 2 * rows.value.size() > all ? rows : Rows{};
}

double mean_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
                 double every) {
    const std::vector<double> rows = rows_over(times, values, from, until, every).value;
    return rows.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : std::accumulate(rows.begin(), rows.end(), 0.0) / static_cast<double>(rows.size());
}

} // namespace tumble::observe
