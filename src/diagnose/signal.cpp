#include "diagnose/signal.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tumble::diagnose {

namespace {

constexpr std::size_t rows_of_side = 4; // of a third-order polynomial
constexpr double least_kink = 3;        // times the bend to either side

/// Where a function changes its sign between two places, by bisection down to rounding; none where it does not.
template <class Function> std::optional<double> root_of(Function function, double lo, double hi) {
    const bool rising = function(lo) < 0;
    if (rising == (function(hi) < 0))
        return std::nullopt;
    for (int k = 0; k < 50; ++k) {
        const double middle = (lo + hi) / 2;
        (rising == (function(middle) < 0) ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

} // namespace

double Signal::at(double t) const {
    if (t <= time.front())
        return value.front();
    if (t >= time.back())
        return value.back();
    const auto above = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    const std::size_t k = above - 1;
    const std::size_t last = time.size() - 1;
    if (kinked(k)) {
        // Harten 1989: both sides go on as they were until they meet.
        const auto left = [&](double at) { return through(k + 1 >= rows_of_side ? k + 1 - rows_of_side : 0, k, at); };
        const auto right = [&](double at) { return through(k + 1, std::min(k + rows_of_side, last), at); };
        if (const auto meet = root_of([&](double at) { return left(at) - right(at); }, time[k], time[k + 1]))
            return t < *meet ? left(t) : right(t);
    }
    std::size_t first = k >= 1 ? k - 1 : 0;
    if (k >= 1 && kinked(k - 1))
        first = k;
    else if (kinked(k + 1))
        first = k >= 2 ? k - 2 : 0;
    const std::size_t width = std::min(rows_of_side, last + 1);
    first = std::min(first, last + 1 - width);
    return through(first, first + width - 1, t);
}

double Signal::bend(std::size_t k) const {
    return ((value[k + 1] - value[k]) / (time[k + 1] - time[k]) - (value[k] - value[k - 1]) / (time[k] - time[k - 1])) /
           (time[k + 1] - time[k - 1]);
}

bool Signal::kinked(std::size_t k) const {
    if (k < 2 || k + 3 >= time.size())
        return false;
    const double outside = std::max(std::abs(bend(k - 1)), std::abs(bend(k + 2)));
    return std::max(std::abs(bend(k)), std::abs(bend(k + 1))) > least_kink * outside; // one alone: close to its row
}

double Signal::through(std::size_t first, std::size_t last, double t) const {
    double sum = 0;
    for (std::size_t i = first; i <= last; ++i) {
        double weight = 1;
        for (std::size_t k = first; k <= last; ++k)
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
