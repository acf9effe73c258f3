#include "diagnose/verdict.h"

#include "diagnose/warning_key.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::diagnose {

namespace {

constexpr int most_decimals = 8;
constexpr double off_the_middle = 0.1; // of what lies between limits: then they are told

/// The unit with a space before it, as sentences have it; of an instrument's numbers that of its channel.
std::string unit_words(const Cause& cause) {
    if (cause.unit.empty() || cause.unit.starts_with("SI unit"))
        return "";
    return " " + (cause.unit == "1_s" ? "1/s" : cause.unit);
}

const Cause& cause_of(const Diagnosis& diagnosis, int k) {
    return diagnosis.causes[static_cast<std::size_t>(k)];
}

std::vector<std::string> ids_of(const Diagnosis& diagnosis, const std::vector<int>& causes) {
    std::vector<std::string> ids;
    for (const int k : causes)
        ids.push_back(cause_of(diagnosis, k).id);
    return ids;
}

/// The family, where all of them are of one.
std::string family_of(const Diagnosis& diagnosis, const std::vector<int>& causes) {
    for (const int k : causes)
        if (cause_of(diagnosis, k).family != cause_of(diagnosis, causes[0]).family)
            return "";
    return cause_of(diagnosis, causes[0]).family;
}

/// The limits of an amplitude that does not lie in the middle of them.
std::string lopsided(const Diagnosis& diagnosis, std::size_t index) {
    if (diagnosis.limits.empty())
        return "";
    const auto [low, high, linear] = diagnosis.limits[index];
    const double at = diagnosis.decision.best->amplitude[static_cast<Eigen::Index>(index)];
    if (linear || std::abs(at - 0.5 * (low + high)) < off_the_middle * (high - low))
        return "";
    const Cause& cause = cause_of(diagnosis, diagnosis.decision.best->causes[index]);
    return fmt::format(" (95 %: {:.3g} to {:.3g}{})", low, high, unit_words(cause));
}

/// " (height_mm at 0.312 m)": where a clipping cuts.
std::string cut_words(const Diagnosis& diagnosis) {
    std::vector<std::string> words;
    for (const Cut& cut : diagnosis.cuts)
        words.push_back(fmt::format("{} at {:.4g} {}", cut.head, cut.limit, cut.unit));
    return words.empty() ? "" : fmt::format(" ({})", fmt::join(words, ", "));
}

std::string found(const Diagnosis& diagnosis, std::size_t index) {
    const Refit& best = *diagnosis.decision.best;
    const Cause& cause = cause_of(diagnosis, best.causes[index]);
    const auto i = static_cast<Eigen::Index>(index);
    return fmt::format("{} ({}): {} = {}{}{}", cause.name, cause.id, cause.symbol,
                       amplitude_words(cause, best.amplitude[i], best.error[i]), lopsided(diagnosis, index),
                       cause.clips() ? cut_words(diagnosis) : "");
}

std::string gain_words(const Diagnosis& diagnosis) {
    if (!diagnosis.gain)
        return " Its gain could not be measured: there is only one condition.";
    const Gain& gain = *diagnosis.gain;
    const std::string where = gain.held_out
                                  ? (diagnosis.beds.empty() ? "on the series held out" : "on the beds held out")
                                  : "on conditions predicted from the others";
    if (!gain.shown)
        return fmt::format(" Named, gain not shown: {} the extended scene is not surely better.", where);
    const bool two = diagnosis.decision.outcome == Outcome::two_causes;
    return fmt::format(" With {} the misfit {} falls from {:.2f} to {:.2f} standard errors of a {}.",
                       two ? "both" : "it", where, gain.rms_baseline, gain.rms_extended,
                       diagnosis.beds.empty() ? "reading" : "mean");
}

std::string doubt_words(const Decision& decision) {
    return decision.sure ? "" : fmt::format(" But {}: UNSURE.", decision.reason);
}

std::string named(const Diagnosis& diagnosis) {
    const Decision& decision = diagnosis.decision;
    std::string text = fmt::format("The data differ from the simulation by {}.", found(diagnosis, 0));
    if (decision.one_class) {
        const std::vector<int> others(decision.causes.begin() + 1, decision.causes.end());
        text += fmt::format(" These data cannot tell it from {}: they are one answer.",
                            fmt::join(ids_of(diagnosis, others), ", "));
    }
    for (const int k : decision.beyond)
        text += fmt::format(" {} would look alike, and {}.", cause_of(diagnosis, k).id,
                            decision.seen[static_cast<std::size_t>(k)].refit->refused);
    text += doubt_words(decision) + gain_words(diagnosis);
    if (decision.second_cause >= 0)
        text += fmt::format(" Beside it a second effect of up to {:.1f} standard errors ({}) is not excluded.",
                            decision.second, cause_of(diagnosis, decision.second_cause).id);
    return text;
}

std::string ambiguous(const Diagnosis& diagnosis) {
    const Decision& decision = diagnosis.decision;
    if (!decision.pairs.empty()) {
        std::vector<std::string> pairs;
        for (const auto& pair : decision.pairs)
            pairs.push_back(fmt::format("{}", fmt::join(ids_of(diagnosis, pair), " with ")));
        return fmt::format("Two causes act together, and these data cannot tell which: {}.", fmt::join(pairs, "; "));
    }
    const std::string family = family_of(diagnosis, decision.causes);
    return fmt::format("Something is missing, and these data cannot tell which of {}{}.",
                       fmt::join(ids_of(diagnosis, decision.causes), ", "),
                       family.empty() ? "" : fmt::format("; all are of one family: {}", family));
}

std::string none_known(const Diagnosis& diagnosis) {
    std::string text = "The data differ from the simulation, and no cause of the library, nor two together, explains "
                       "how.";
    if (diagnosis.decision.best)
        text += fmt::format(" Nearest comes {}, which leaves more than noise.",
                            cause_of(diagnosis, diagnosis.decision.best->causes[0]).id);
    if (diagnosis.overstated) {
        text += fmt::format(" If {} may lie anywhere, whatever was said of it beforehand, only noise is left.",
                            diagnosis.overstated->what);
        if (!diagnosis.alike.empty())
            text += fmt::format(" In these readings it looks like {}.", fmt::join(diagnosis.alike, ", "));
    }
    if (diagnosis.differing)
        text += fmt::format(" It is not one cause: conditions differ (het.condition). With a value of its own of {} in "
                            "each of them only noise is left{}.",
                            diagnosis.differing->what,
                            diagnosis.differing->most.empty() ? "" : "; most of it is " + diagnosis.differing->most);
    return text;
}

std::string consistent(const Diagnosis& diagnosis) {
    return fmt::format("The simulation agrees with the data: {} scatter about it as their noise does. Effects "
                       "beyond the limits that stand beside each cause are excluded.",
                       diagnosis.beds.empty() ? fmt::format("{} readings", diagnosis.readings)
                                              : fmt::format("{} means of the bed", diagnosis.readings));
}

} // namespace

std::string outcome_words(const Diagnosis& diagnosis) {
    const Decision& decision = diagnosis.decision;
    switch (decision.outcome) {
    case Outcome::consistent:
        return "CONSISTENT WITH THE BASELINE";
    case Outcome::named:
        return decision.sure ? (decision.one_class ? "NAMED, AS ONE CLASS" : "NAMED") : "UNSURE";
    case Outcome::ambiguous:
        return "AMBIGUOUS";
    case Outcome::two_causes:
        return decision.sure ? "TWO CAUSES" : "UNSURE";
    case Outcome::none_known:
        return "NONE OF THE KNOWN CAUSES";
    case Outcome::cannot_decide:
        break;
    }
    return "CANNOT DECIDE";
}

std::string verdict_of(const Diagnosis& diagnosis) {
    switch (diagnosis.decision.outcome) {
    case Outcome::consistent:
        return consistent(diagnosis);
    case Outcome::named:
        return named(diagnosis);
    case Outcome::ambiguous:
        return ambiguous(diagnosis);
    case Outcome::two_causes:
        return fmt::format("Two causes act together: {}; {}.{}{}", found(diagnosis, 0), found(diagnosis, 1),
                           doubt_words(diagnosis.decision), gain_words(diagnosis));
    case Outcome::none_known:
        return none_known(diagnosis);
    case Outcome::cannot_decide:
        break;
    }
    return fmt::format("No verdict: {}.", diagnosis.decision.reason);
}

std::string next_step(const Diagnosis& diagnosis) {
    const auto& proposals = diagnosis.proposals;
    const std::string first = diagnosis.decision.outcome == Outcome::ambiguous && !diagnosis.decision.remedy.empty()
                                  ? diagnosis.decision.remedy + " Then: "
                                  : "";
    const bool to_part = diagnosis.decision.outcome == Outcome::ambiguous || diagnosis.decision.one_class;
    if (to_part && !proposals.empty() && proposals[0].repeats > 0)
        return first + fmt::format("To tell them apart, {}{}: that would set them {:.1f} standard errors apart.",
                                   proposals[0].sentence,
                                   proposals[0].repeats > 1 ? fmt::format(", {} times", proposals[0].repeats) : "",
                                   proposals[0].reached);
    switch (diagnosis.decision.outcome) {
    case Outcome::consistent:
        if (const Problem* far = warned_of(diagnosis.warnings, warning_key::far_off))
            return fmt::format("First find out whether that can be: {}. If it cannot, the agreement is none.",
                               far->what);
        return "Nothing needs to be changed; to exclude smaller effects, measure more often or under more conditions.";
    case Outcome::named:
        if (!diagnosis.decision.sure)
            return diagnosis.decision.remedy;
        if (diagnosis.extended)
            return "Confirm the extended scene (--write-extended writes it) with an experiment not used here.";
        if (cause_of(diagnosis, diagnosis.decision.causes[0]).clips())
            return "It is the instrument, not the scene. What it cut off cannot be brought back: leave those rows out, "
                   "or "
                   "record again with a larger range.";
        if (const Problem* low = warned_of(diagnosis.warnings, warning_key::lowest_point);
            low && cause_of(diagnosis, diagnosis.decision.causes[0]).id.starts_with("ins.bias"))
            return "First see to the readings: " + low->what;
        return fmt::format(
            "It is the instrument, not the scene: calibrate it ({}) or correct the readings, and confirm it "
            "with an experiment not used here.",
            cause_of(diagnosis, diagnosis.decision.causes[0]).keys);
    case Outcome::ambiguous:
        return first +
               "No experiment of the catalogue would tell them apart. Measure under another condition: at another "
               "speed, "
               "height or angle, or both ways; or measure another quantity.";
    case Outcome::two_causes:
        return diagnosis.decision.sure ? "Confirm each with an experiment in which the other cannot act."
                                       : diagnosis.decision.remedy;
    case Outcome::none_known:
        if (!diagnosis.decision.remedy.empty())
            return diagnosis.decision.remedy;
        if (diagnosis.overstated)
            return fmt::format(
                "Find out whether {} can have gone that far. If so, state a larger spread of it; if not{}.",
                diagnosis.overstated->what,
                diagnosis.alike.empty() ? ", something looks like it that is in no library"
                                        : ", it is what looks like it: measure that by itself");
        if (diagnosis.differing)
            return fmt::format(
                "Find out what changed between the conditions, and hold it still; or, if it is innocent, "
                "give {} as a nuisance with per = \"series\".",
                diagnosis.differing->what);
        return (diagnosis.follows.all.empty()
                    ? "Look at the residual: what does it follow?"
                    : fmt::format("What is left follows most of all {}, by {:.1f} standard "
                                  "errors. Ask what could do that.",
                                  diagnosis.follows.all[0].what, std::abs(diagnosis.follows.all[0].z))) +
               " Then check the apparatus, or add the missing law to the scene.";
    case Outcome::cannot_decide:
        break;
    }
    if (!diagnosis.decision.remedy.empty())
        return diagnosis.decision.remedy;
    return "Measure under more conditions, or state what is known about the nuisances (spread).";
}

std::string extended_claim(const Diagnosis& diagnosis) {
    const auto count = diagnosis.decision.best->causes.size();
    std::vector<std::string> causes;
    for (std::size_t k = 0; k < count; ++k)
        causes.push_back(found(diagnosis, k));
    std::string text =
        fmt::format("{} with what {} named (`tumble diagnose`): {}.", diagnosis.scene.filename().string(),
                    diagnosis.data.filename().string(), fmt::join(causes, "; "));
    std::vector<std::string> adjusted;
    for (const FittedNuisance& nuisance : diagnosis.nuisances)
        if (nuisance.extended && nuisance.in_scene)
            adjusted.push_back(fmt::format("{} = {:.6g}", nuisance.name, *nuisance.extended));
    if (!adjusted.empty())
        text += fmt::format(" Adjusted with it: {}.", fmt::join(adjusted, ", "));
    return text;
}

std::string amplitude_words(const Cause& cause, double amplitude, double error) {
    const std::string unit = unit_words(cause);
    const int decimals =
        error > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(error)))) : most_decimals + 1;
    if (decimals <= most_decimals) // both to the error's second digit
        return fmt::format("{0:.{2}f} +- {1:.{2}f}{3}", amplitude, error, decimals, unit);
    return fmt::format("{:.4g} +- {:.2g}{}", amplitude, error, unit);
}

std::string standing_of(const Diagnosis& diagnosis, int cause) {
    const Decision& decision = diagnosis.decision;
    if (decision.seen.empty())
        return "";
    const Seen& seen = decision.seen[static_cast<std::size_t>(cause)];
    if (!seen.visible)
        return seen.share == 0      ? (diagnosis.beds.empty() ? "does not act here" : "does no more than seeds do")
               : seen.share < 0.005 ? "does not show: nuisances absorb it"
                                    : "does not show in these data";
    if (std::find(decision.causes.begin(), decision.causes.end(), cause) != decision.causes.end())
        return decision.outcome != Outcome::ambiguous ? (decision.sure ? "named" : "named, unsure")
               : decision.pairs.empty() && seen.refit
                   ? "may be it: " +
                         amplitude_words(cause_of(diagnosis, cause), seen.refit->amplitude[0], seen.refit->error[0])
                   : "may be it";
    if (seen.refit && !seen.refit->possible)
        return "refused: " + seen.refit->refused;
    const bool one_explains_it = decision.outcome == Outcome::named ||
                                 (decision.outcome == Outcome::ambiguous && decision.pairs.empty()) ||
                                 (decision.outcome == Outcome::none_known && decision.largest >= decision.gate);
    if (decision.best && one_explains_it) {
        if (decision.best->causes == std::vector<int>{cause})
            return "comes nearest";
        const double behind = nats_between(diagnosis.evidence, decision.best->gain, seen.gain);
        return behind < 0 && !seen.refit ? "as near by its slope, not fitted"
                                         : fmt::format("{:.1f} nats behind", behind);
    }
    if (decision.best && decision.best->causes.size() == 2)
        return fmt::format("alone {:.1f} nats behind the pair",
                           nats_between(diagnosis.evidence, decision.best->gain, seen.gain));
    if (decision.outcome == Outcome::none_known)
        return "no limit: the scene does not fit";
    const Cause& suspect = cause_of(diagnosis, cause);
    // Limits that leave 0 out are chance where nothing shows: a name would need the gate.
    const double low = std::clamp(seen.lower, suspect.lo, 0.0), high = std::clamp(seen.upper, 0.0, suspect.hi);
    return suspect.lo == 0
               ? fmt::format("below {:.2g}{} (95 %)", high, unit_words(suspect))
               : fmt::format("between {:.2g} and {:.2g}{} (each at least 95 %)", low, high, unit_words(suspect));
}

} // namespace tumble::diagnose
