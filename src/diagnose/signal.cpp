#include "diagnose/signal.h"

#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

double Signal::at(double t) const {
    if (t <= time.front())
        return value.front();
    if (t >= time.back())
        return value.back();
    const auto above = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    const std::size_t rows = time.size();
    const std::size_t width = std::min<std::size_t>(4, rows);
    const std::size_t first = std::min(above >= 2 ? above - 2 : 0, rows - width);
    double sum = 0;
    for (std::size_t i = first; i < first + width; ++i) {
        double weight = 1;
        for (std::size_t k = first; k < first + width; ++k)
            if (k != i)
                weight *= (t - time[k]) / (time[i] - time[k]);
        sum += weight * value[i];
    }
    return sum;
}

double Signal::rate_at(double t) const {
    const double row = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    return (at(t + row) - at(t - row)) / (2 * row);
}

Signal Signal::low_passed(double time_constant, double from) const {
    Signal passed{time, value};
    passed.value.front() = from;
    for (std::size_t k = 1; k < time.size(); ++k) {
        // y' = (x - y) / tau with x straight between the rows.
        const double step = (time[k] - time[k - 1]) / time_constant;
        const double decay = std::exp(-step);
        const double slope = (value[k] - value[k - 1]) / step;
        passed.value[k] = value[k] - slope + (passed.value[k - 1] - value[k - 1] + slope) * decay;
    }
    return passed;
}

} // namespace tumble::diagnose
