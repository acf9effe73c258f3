#include "diagnose/bed_number.h"

#include "diagnose/measure_units.h"
#include "observe/mean_over.h"
#include "observe/tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tumble::diagnose {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double turned_round = 0.5; // of the standard deviation, to either side of the mean: less is no cycle

struct Rows {
    std::vector<double> time, value;
};

/// Rows of the stretch that have a value; none where most have not. As mean_over() chooses them.
Rows rows_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
               double every) {
    Rows rows;
    std::size_t all = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (times[k] <= from + every / 2 || times[k] > until + every / 2)
            continue;
        ++all;
        if (std::isfinite(values[k])) {
            rows.time.push_back(times[k]);
            rows.value.push_back(values[k]);
        }
    }
    return 2 * rows.value.size() > all ? rows : Rows{};
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Between the two nearest ranks.
double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

double root_mean_square(std::vector<double> values) {
    for (double& value : values)
        value *= value;
    return std::sqrt(mean_of(values));
}

double mean_cycle(const Rows& rows) {
    const double mean = mean_of(rows.value);
    std::vector<double> about = rows.value;
    for (double& value : about)
        value -= mean;
    const double least = turned_round * root_mean_square(about);
    std::vector<double> rises;
    bool below = false;
    for (std::size_t k = 0; k < about.size(); ++k) {
        if (about[k] > least && below)
            rises.push_back(rows.time[k]);
        if (std::abs(about[k]) > least)
            below = about[k] < 0;
    }
    return rises.size() < 3 ? none : (rises.back() - rises.front()) / static_cast<double>(rises.size() - 1);
}

} // namespace

const std::vector<std::string>& words_of_bed_takes() {
    static const std::vector<std::string> words{"mean", "rms", "q10", "q50", "q90", "cycle"};
    return words;
}

BedNumberName bed_number_named(const std::string& name) {
    for (const std::string& word : words_of_bed_takes())
        if (name.starts_with(word + " of "))
            return {word, name.substr(word.size() + 4)};
    return {"mean", name};
}

std::string observed_for(const BedNumberName& name) {
    const auto traced = observe::traced_by(name.measure);
    return traced ? "tracer:" + traced->body : name.measure;
}

Result<std::string> head_of(const BedNumberName& name) {
    const auto unit = unit_of(name.measure);
    if (!unit)
        return unit.problems();
    return name.joined() + (unit->empty() ? "" : "_" + *unit);
}

Result<std::string> unit_of_number(const BedNumberName& name) {
    const auto unit = unit_of(name.measure);
    return name.take == "cycle" && unit ? Result<std::string>(std::string("s")) : unit;
}

double number_over(const std::string& take, const std::vector<double>& times, const std::vector<double>& values,
                   double from, double until, double every) {
    if (take == "mean")
        return observe::mean_over(times, values, from, until, every);
    const Rows rows = rows_over(times, values, from, until, every);
    if (rows.value.empty())
        return none;
    if (take == "rms")
        return root_mean_square(rows.value);
    if (take == "cycle")
        return mean_cycle(rows);
    return quantile(rows.value, take == "q10" ? 0.1 : take == "q50" ? 0.5 : 0.9);
}

} // namespace tumble::diagnose
