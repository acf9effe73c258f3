#include "diagnose/taken.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

std::size_t highest_from(const std::vector<double>& values, std::size_t first) {
    return static_cast<std::size_t>(
        std::max_element(values.begin() + static_cast<std::ptrdiff_t>(first), values.end()) - values.begin());
}

/// Turned over where the lowest is taken.
std::vector<double> seen_over(const Channel& channel, double until, const Instrument& instrument, const Signal& truth,
                              double largest) {
    std::vector<double> times;
    for (int k = 0; k <= instants; ++k)
        times.push_back(channel.from + (until - channel.from) * k / instants);
    std::vector<double> seen = seen_through(instrument, truth, times, largest);
    if (channel.take == Take::lowest)
        for (double& value : seen)
            value = -value;
    return seen;
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
    const std::vector<double> seen = seen_over(channel, until, instrument, truth, largest);
    switch (channel.take) {
    case Take::highest:
        return top_about(seen, highest_from(seen, 0));
    case Take::lowest:
        return -top_about(seen, highest_from(seen, 0));
    case Take::rebound:
        return top_about(seen, highest_from(seen, first_lowest(seen)));
    case Take::mean:
        return std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size());
    case Take::last:
    case Take::reading:
        break;
    }
    return seen.back();
}

double degrees_of_numbers(const std::vector<Record>& records) {
    double least = std::numeric_limits<double>::infinity();
    for (const Record& record : records)
        for (const Channel& channel : record.channels)
            least = std::min(least, channel.degrees);
    const bool all = std::all_of(records.begin(), records.end(), [](const Record& record) { return record.single(); });
    return all ? least : std::numeric_limits<double>::infinity();
}

bool at_an_end(const Channel& channel, double until, const Signal& truth) {
    if (channel.take == Take::last || channel.take == Take::mean || channel.take == Take::reading)
        return false;
    const std::vector<double> seen = seen_over(channel, until, {}, truth, 0);
    const std::size_t down = channel.take == Take::rebound ? first_lowest(seen) : 0;
    const std::size_t at = highest_from(seen, down);
    return channel.take == Take::rebound ? at == down || at + 1 == seen.size() : at == 0 || at + 1 == seen.size();
}

} // namespace tumble::diagnose
