#include "diagnose/fit_doubts.h"

#include "diagnose/taken.h"

#include <fmt/format.h>

namespace tumble::diagnose {

void doubt_bounds(const Model& model, const VectorXd& values, const std::filesystem::path& file, Problems& warnings) {
    for (int k = 0; k < model.nuisances(); ++k) {
        const Parameter& parameter = model.parameters()[static_cast<std::size_t>(k)];
        const double value = values[k];
        if (value > parameter.lo && value < parameter.hi)
            continue;
        warnings.push_back(
            {.file = file.string(),
             .key = "nuisance at its bound",
             .what = fmt::format("{} ended at {:g}, as far from {:g} as a fit may take it", parameter.name, value,
                                 parameter.start),
             .fix = "let the scene begin nearer to it or state a larger spread; if it cannot be true, look for a slip "
                    "of units or of files"});
    }
}

void doubt_numbers(Model& model, const VectorXd& values, Problems& warnings) {
    for (std::size_t r = 0; r < model.records().size(); ++r) {
        const Record& record = model.records()[r];
        if (!record.single())
            continue;
        const auto truth = model.signals(values, static_cast<int>(r));
        for (std::size_t c = 0; truth && c < truth->size(); ++c)
            if (at_an_end(record.channels[c], record.time[0], (*truth)[c]))
                warnings.push_back(
                    {.file = record.file.string(),
                     .key = "end of the stretch",
                     .what = fmt::format("{}: {} of {} lies at an end of {:g} to {:g} s in the simulation", record.name,
                                         words_of_takes()[static_cast<std::size_t>(record.channels[c].take) - 1],
                                         record.channels[c].measure, record.channels[c].from, record.time[0]),
                     .fix = "let until_s be later, or from_s earlier, unless that is what was measured"});
    }
}

void doubt_sensors(Decision& decision, const Problems& warnings) {
    if (decision.outcome == Outcome::consistent)
        return;
    for (const char* key : {warning_key::velocity_against_way, warning_key::peak_speed, warning_key::speed})
        if (const Problem* wrong = warned_of(warnings, key)) {
            if (names(decision) && !decision.sure)
                return;
            decision.remedy = "First find out which sensor is wrong: " + wrong->what + ".";
            if (names(decision)) {
                decision.sure = false;
                decision.reason = "the readings contradict each other, whatever the simulation says";
            }
            return;
        }
    if (names(decision)) // what a cause explains is no slip
        return;
    if (const Problem* late = warned_of(warnings, warning_key::shifted))
        decision.remedy = "First see to the time: " + late->what + ".";
    else if (const Problem* dead = warned_of(warnings, warning_key::dead))
        decision.remedy = "First see to the readings: " + dead->what + ".";
    else if (const Problem* cut = warned_of(warnings, warning_key::clipped))
        decision.remedy = "First see to the readings: " + cut->what +
                          ". Leave out the rows that it cut, or record again with a larger range.";
    else
        for (const char* key : {warning_key::unit, warning_key::lowest_point})
            if (const Problem* slip = warned_of(warnings, key)) {
                decision.remedy = "First see to the readings: " + slip->what;
                return;
            }
}

void doubt_name(Decision& decision, const std::vector<Cause>& causes, const Problems& warnings) {
    doubt_sensors(decision, warnings);
    if (!names(decision) || !decision.sure)
        return;
    const bool clips = std::any_of(decision.causes.begin(), decision.causes.end(),
                                   [&](int k) { return causes[static_cast<std::size_t>(k)].clips(); });
    if (const Problem* cut = warned_of(warnings, warning_key::clipped); cut && !clips) {
        decision.sure = false;
        decision.reason = "readings are clipped (" + cut->what + "), and what was cut off may be the cause";
        decision.remedy = "Record it again with a sensor of a larger range.";
    }
}

} // namespace tumble::diagnose
