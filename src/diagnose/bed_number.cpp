#include "diagnose/bed_number.h"

#include "diagnose/measure_units.h"
#include "observe/cycle.h"
#include "observe/mean_over.h"
#include "observe/tracer.h"

#include <cmath>
#include <limits>

namespace tumble::diagnose {

namespace {

double root_mean_square(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values)
        squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
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
    const observe::Rows rows = observe::rows_over(times, values, from, until, every);
    if (take == "cycle")
        return observe::find_cycle(rows.time, rows.value).period;
    if (take == "rms")
        return rows.value.empty() ? std::numeric_limits<double>::quiet_NaN() : root_mean_square(rows.value);
    return observe::quantile(rows.value, take == "q10" ? 0.1 : take == "q50" ? 0.5 : 0.9);
}

} // namespace tumble::diagnose
