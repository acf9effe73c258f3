#include "diagnose/taken.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tumble::diagnose {

namespace {

constexpr int instants = 400;

/// Top of the parabola through value k and its neighbours; the value itself at either end.
double top_about(const std::vector<double>& values, std::size_t k) {
    if (k == 0 || k + 1 == values.size())
        return values[k];
    const double left = values[k - 1], right = values[k + 1];
    const double bend = left - 2 * values[k] + right;
    return bend < 0 ? values[k] - (right - left) * (right - left) / (8 * bend) : values[k];
}

double highest_from(const std::vector<double>& values, std::size_t first) {
    const auto at = std::max_element(values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
    return top_about(values, static_cast<std::size_t>(at - values.begin()));
}

std::size_t first_lowest(const std::vector<double>& values) {
    std::size_t k = 0;
    while (k + 1 < values.size() && values[k + 1] >= values[k]) // rises first, as what is thrown up does
        ++k;
    while (k + 1 < values.size() && values[k + 1] < values[k])
        ++k;
    return k;
}

} // namespace

double number_taken(const Channel& channel, double until, const Instrument& instrument, const Signal& truth,
                    double largest) {
    std::vector<double> times;
    for (int k = 0; k <= instants; ++k)
        times.push_back(channel.from + (until - channel.from) * k / instants);
    std::vector<double> seen = seen_through(instrument, truth, times, largest);
    switch (channel.take) {
    case Take::highest:
        return highest_from(seen, 0);
    case Take::lowest:
        for (double& value : seen)
            value = -value;
        return -highest_from(seen, 0);
    case Take::mean:
        return std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size());
    case Take::rebound: {
        const std::size_t down = first_lowest(seen);
        return highest_from({seen.begin() + static_cast<std::ptrdiff_t>(down), seen.end()}, 0);
    }
    case Take::last:
    case Take::reading:
        break;
    }
    return seen.back();
}

} // namespace tumble::diagnose
