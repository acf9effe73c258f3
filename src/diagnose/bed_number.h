#pragma once

#include "base/problem.h"

#include <string>
#include <vector>

namespace tumble::diagnose {

/// What of a measure over a stretch of time is compared: its mean, the usual one; its root mean square; the value that
/// a tenth, half or nine tenths of the rows stay below; or the time of a cycle as observe::find_cycle() has it.
const std::vector<std::string>& words_of_bed_takes();

/// A number of a bed by the name that goes through a diagnosis: "circulation", or "q90 of tracer:sensor_vy".
struct BedNumberName {
    std::string take = "mean"; // one of words_of_bed_takes()
    std::string measure;

    [[nodiscard]] std::string joined() const { return take == "mean" ? measure : take + " of " + measure; }
};
BedNumberName bed_number_named(const std::string& name);

/// What a scene has to observe for it: "tracer:sensor" for a column of that tracer.
std::string observed_for(const BedNumberName& name);

/// Head of its column in a table of runs, with the measure's unit: "q90 of tracer:sensor_vy_m_s". Problems: there is no
/// such measure.
Result<std::string> head_of(const BedNumberName& name);

/// SI unit of the number. Problems: there is no such measure.
Result<std::string> unit_of_number(const BedNumberName& name);

/// The number of the rows after `from` up to `until` (s), which stand `every` (s) apart; NaN where most of them have no
/// value, and for cycles where there are fewer than two.
double number_over(const std::string& take, const std::vector<double>& times, const std::vector<double>& values,
                   double from, double until, double every);

} // namespace tumble::diagnose
