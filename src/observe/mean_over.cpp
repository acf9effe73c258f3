#include "observe/mean_over.h"

#include <cmath>
#include <limits>

namespace tumble::observe {

double mean_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
                 double every) {
    double sum = 0;
    int rows = 0, with_value = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] > from + every / 2 && times[i] <= until + every / 2) {
            ++rows;
            if (std::isfinite(values[i])) {
                sum += values[i];
                ++with_value;
            }
        }
    return 2 * with_value > rows ? sum / with_value : std::numeric_limits<double>::quiet_NaN();
}

} // namespace tumble::observe
