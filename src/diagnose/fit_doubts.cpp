#include "diagnose/fit_doubts.h"

#include "base/column.h"
#include "diagnose/taken.h"
#include "diagnose/warning_key.h"

#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double middle_of_normal = 0.6745; // of the magnitudes, standard deviations
constexpr double of_few = 0.5;              // of the root mean square: what usual readings scatter where few miss most
constexpr double neighbours_alike = 0.5;    // correlation of neighbours: what is missed is no scatter

/// Ended by a full stop, or by its question mark.
std::string sentence(const std::string& text) {
    return text.ends_with('?') ? text : text + ".";
}

} // namespace

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
                     .key = warning_key::end_of_stretch,
                     .what = fmt::format("{}: {} of {} lies at an end of {:g} to {:g} s in the simulation", record.name,
                                         words_of_takes()[static_cast<std::size_t>(record.channels[c].take) - 1],
                                         record.channels[c].measure, record.channels[c].from, record.time[0]),
                     .fix = record.channels[c].take == Take::rebound
                                ? "let until_s be later, unless that is what was measured"
                                : "take = \"rebound\" leaves out how it begins; else let from_s or until_s be later, "
                                  "unless that is what was measured"});
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
    const auto see_to = [&](const char* what, const Problem& slip) {
        decision.remedy = fmt::format("First see to the {}: {}", what, sentence(slip.what));
    };
    if (const Problem* dead = first_warned_of(warnings, {warning_key::dead, warning_key::stuck, warning_key::doubled}))
        see_to("readings", *dead);
    else if (const Problem* slip = first_of(warnings, is_slip)) {
        const bool of_time = slip->key == warning_key::shifted || slip->key == warning_key::jump ||
                             slip->key == warning_key::rate || slip->key == warning_key::too_short;
        see_to(of_time                                   ? "time"
               : slip->key == warning_key::forgotten_set ? "conditions"
               : slip->key == warning_key::unit          ? "readings"
                                                         : "files",
               *slip);
    } else if (const Problem* cut = warned_of(warnings, warning_key::clipped))
        decision.remedy = "First see to the readings: " + cut->what +
                          ". Leave out the rows that it cut, or record again with a larger range.";
    else if (const Problem* number =
                 first_warned_of(warnings, {warning_key::lowest_point, warning_key::end_of_stretch}))
        decision.remedy = fmt::format("First see to the readings: {} ({}.)", sentence(number->what), number->fix);
}

void doubt_agreement(Decision& decision, const NoiseReport& noise, const VectorXd& residual, const Model& model) {
    if (decision.outcome != Outcome::consistent || noise.above < much_wider)
        return;
    const auto readings = static_cast<Eigen::Index>(model.rows().size());
    std::vector<double> sizes;
    double squares = 0, strongest = 0;
    Eigen::Index worst = 0;
    for (Eigen::Index k = 0; k < readings; ++k) {
        sizes.push_back(std::abs(residual[k]));
        squares += residual[k] * residual[k];
        if (sizes.back() > strongest) {
            strongest = sizes.back();
            worst = k;
        }
    }
    const double usual = median(sizes) / middle_of_normal;
    const bool smooth = std::any_of(noise.of.begin(), noise.of.end(), [](const auto& one) {
        return one.second.ratio > much_wider && one.second.correlation > neighbours_alike;
    });
    const bool few = usual < of_few * std::sqrt(squares / static_cast<double>(readings));
    if (!smooth && !few)
        return;
    const Row& row = model.rows()[static_cast<std::size_t>(worst)];
    decision.outcome = Outcome::cannot_decide;
    decision.reason = fmt::format(
        "readings miss the simulation by {:.0f} times what was known of their scatter, and {}, so no effect would show "
        "beside it",
        noise.above, few ? "most of it comes of a few" : "neighbours miss it alike");
    decision.remedy =
        fmt::format("First see to the readings of {} in '{}' about {:.4g} s, where the most is missed: are "
                    "they the body's?",
                    model.channel_of(row).head, model.record_of(row).name, row.time);
}

void doubt_name(Decision& decision, const std::vector<Cause>& causes, const Problems& warnings) {
    doubt_sensors(decision, warnings);
    if (!names(decision) || !decision.sure)
        return;
    const bool clips = std::any_of(decision.causes.begin(), decision.causes.end(),
                                   [&](int k) { return causes[static_cast<std::size_t>(k)].clips(); });
    if (const Problem* held = warned_of(warnings, warning_key::stuck)) {
        decision.sure = false;
        decision.reason = "readings were held (" + held->what + "), and that may be the cause";
        decision.remedy = "Leave those rows out.";
    } else if (const Problem* cut = warned_of(warnings, warning_key::clipped); cut && !clips) {
        decision.sure = false;
        decision.reason = "readings are clipped (" + cut->what + "), and what was cut off may be the cause";
        decision.remedy = "Record it again with a sensor of a larger range.";
    }
}

} // namespace tumble::diagnose
