#include "report/diagnosis_json.h"

#include "base/distributions.h"
#include "base/table.h"
#include "base/text.h"
#include "diagnose/fingerprints.h"
#include "diagnose/verdict.h"
#include "report/residual_plots.h"

#include <cmath>

namespace tumble::report {

using namespace diagnose;
using Json = nlohmann::ordered_json;

namespace {

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json ids_of(const Diagnosis& diagnosis, const std::vector<int>& causes) {
    Json ids = Json::array();
    for (const int k : causes)
        ids.push_back(diagnosis.causes[static_cast<std::size_t>(k)].id);
    return ids;
}

Json amplitudes_of(const Diagnosis& diagnosis) {
    Json all = Json::array();
    const double reach = student_quantile(0.025, diagnosis.evidence.degrees);
    if (const auto& best = diagnosis.decision.best)
        for (std::size_t k = 0; k < best->causes.size(); ++k) {
            const Cause& cause = diagnosis.causes[static_cast<std::size_t>(best->causes[k])];
            const auto i = static_cast<Eigen::Index>(k);
            const double half = reach * best->error[i];
            Limits limits{best->amplitude[i] - half, best->amplitude[i] + half, true}; // a bed's, or not named
            if (!diagnosis.limits.empty())
                limits = diagnosis.limits[k];
            else if (diagnosis.decision.outcome == Outcome::none_known) // what does not fit has none
                limits.low = limits.high = std::nan("");
            all.push_back({{"id", cause.id},
                           {"family", cause.family},
                           {"parameter", cause.symbol},
                           {"unit", cause.unit},
                           {"amplitude", number(best->amplitude[i])},
                           {"standard_error", number(best->error[i])},
                           {"low_95", number(limits.low)},
                           {"high_95", number(limits.high)},
                           {"limits_are_linear", limits.linear}});
        }
    return all;
}

/// Of the best single explanation; none where nothing was fitted.
double nats_behind(const Diagnosis& diagnosis, const Seen& seen) {
    const auto& best = diagnosis.decision.best;
    return best && best->causes.size() == 1 ? nats_between(diagnosis.evidence, best->gain, seen.gain) : std::nan("");
}

Json library_of(const Diagnosis& diagnosis) {
    Json all = Json::array();
    for (std::size_t k = 0; k < diagnosis.decision.seen.size(); ++k) {
        const Cause& cause = diagnosis.causes[k];
        const Seen& seen = diagnosis.decision.seen[k];
        all.push_back({{"id", cause.id},
                       {"visible", seen.visible},
                       {"share_left_by_nuisances", number(seen.share)},
                       {"amplitude_linear", number(seen.amplitude)},
                       {"standard_error", number(seen.error)},
                       {"chi_square_gain", number(seen.gain)},
                       {"chi_square_reached", number(seen.refit ? std::max(0.0, seen.refit->gain) : seen.gain)},
                       {"nats_behind", number(nats_behind(diagnosis, seen))},
                       {"refitted", seen.refit.has_value()},
                       {"lower_95_one_sided", number(seen.lower)},
                       {"upper_95_one_sided", number(seen.upper)},
                       {"standing", standing_of(diagnosis, static_cast<int>(k))}});
    }
    return all;
}

Json isolability_of(const Diagnosis& diagnosis) {
    Json rows = Json::array();
    const MatrixXd& left = diagnosis.decision.isolability;
    for (Eigen::Index i = 0; i < left.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index j = 0; j < left.cols(); ++j)
            row.push_back(number(left(i, j)));
        rows.push_back(std::move(row));
    }
    return rows;
}

Json gain_of_it(const Gain& gain) {
    Json conditions = Json::array();
    for (const Score& score : gain.scores)
        conditions.push_back({{"condition", score.condition},
                              {"readings", score.readings},
                              {"chi_square_baseline", score.baseline},
                              {"chi_square_extended", score.extended},
                              {"nats", score.nats()}});
    Json json{{"on", gain.held_out ? "series held out" : "each condition from the others"},
              {"rms_baseline", gain.rms_baseline},
              {"rms_extended", gain.rms_extended},
              {"skill", gain.skill},
              {"share_of_misfit_removed", gain.share_removed},
              {"nats", gain.nats},
              {"shown", gain.shown},
              {"conditions", std::move(conditions)}};
    if (gain.bootstrapped)
        json["nats_95"] = {gain.nats_low, gain.nats_high};
    return json;
}

Json beds_of(const Diagnosis& diagnosis) {
    Json all = Json::array();
    for (const BedNumber& one : diagnosis.beds) {
        Json json{{"condition", one.condition},
                  {"measure", one.measure},
                  {"unit", one.unit},
                  {"held_out", one.held_out},
                  {"measured", one.measured},
                  {"measured_standard_error", one.measured_error},
                  {"runs_measured", one.runs},
                  {"baseline", one.baseline},
                  {"baseline_standard_error", one.baseline_error},
                  {"scatter_of_single_runs", one.scatter},
                  {"seeds", one.seeds}};
        if (one.has_extended) {
            json["extended"] = one.extended;
            json["extended_standard_error"] = one.extended_error;
        }
        all.push_back(std::move(json));
    }
    return all;
}

Json adequacy_of_it(const Adequacy& adequacy) {
    Json json{{"p_blocks", adequacy.blocks}, {"p_fingerprints", adequacy.prints}, {"p_strongest", adequacy.strongest}};
    if (adequacy.swing)
        json["p_swings"] = adequacy.swing->p;
    json["p"] = adequacy.p();
    return json;
}

Json besides_of(const std::optional<Besides>& besides) {
    if (!besides)
        return {};
    return {
        {"what", besides->what}, {"numbers", besides->numbers}, {"chi_square_gain", besides->gain}, {"p", besides->p}};
}

Json along_it(const std::optional<Along>& along) {
    if (!along)
        return {};
    return {{"slope", number(along->slope)}, {"standard_error", number(along->error)}, {"z", number(along->z)}};
}

/// Each direction with what goes along it, of the baseline's residual and of the best explanation's; null: taken up.
Json fingerprints_as_json(const Diagnosis& diagnosis) {
    Json all = Json::array();
    for (const Fingerprint& print : fingerprints_of(diagnosis.evidence, diagnosis.decision))
        all.push_back({{"what", print.what},
                       {"unit", print.unit},
                       {"baseline", along_it(print.scene)},
                       {"best_explanation", along_it(print.best)}});
    return all;
}

Json decision_of(const Diagnosis& diagnosis) {
    const Decision& decision = diagnosis.decision;
    Json pairs = Json::array();
    for (const auto& pair : decision.pairs)
        pairs.push_back(ids_of(diagnosis, pair));
    Json follows = Json::array();
    for (const Followed& one : diagnosis.follows.all)
        follows.push_back({{"what", one.what}, {"standard_errors", one.z}});
    Json differing = besides_of(diagnosis.differing), overstated = besides_of(diagnosis.overstated);
    if (diagnosis.differing) {
        differing["id"] = "het.condition";
        differing["most"] = diagnosis.differing->most;
    }
    if (diagnosis.overstated)
        overstated["looks_like"] = diagnosis.alike;
    Json folds = Json::array();
    for (const Fold& fold : decision.folds)
        folds.push_back({{"without", fold.score.condition},
                         {"amplitude", number(fold.amplitude)},
                         {"moved_standard_errors", number(fold.moved)},
                         {"readings", fold.score.readings},
                         {"chi_square_baseline", fold.score.baseline},
                         {"chi_square_extended", fold.score.extended},
                         {"nats", fold.score.nats()}});
    Json second; // null: none was bounded
    if (decision.second_cause >= 0)
        second = {{"id", diagnosis.causes[static_cast<std::size_t>(decision.second_cause)].id},
                  {"standard_errors", decision.second}};
    return {{"outcome", outcome_words(diagnosis)},
            {"verdict", verdict_of(diagnosis)},
            {"next", next_step(diagnosis)},
            {"causes", ids_of(diagnosis, decision.causes)},
            {"one_class", decision.one_class},
            {"sure", decision.sure},
            {"reason", decision.reason},
            {"pairs", std::move(pairs)},
            {"fitted", amplitudes_of(diagnosis)},
            {"gate", decision.gate},
            {"largest_chi_square_gain", decision.largest},
            {"second_effect_up_to", second},
            {"adequacy_baseline", adequacy_of_it(decision.baseline)},
            {"adequacy_winner", adequacy_of_it(decision.winner)},
            {"folds", std::move(folds)},
            {"conditions_differ", std::move(differing)},
            {"overstated_beforehand", std::move(overstated)},
            {"residual_follows", std::move(follows)},
            {"fingerprints", fingerprints_as_json(diagnosis)},
            {"directions_tried", diagnosis.follows.tried},
            {"directions_gate", diagnosis.follows.gate}};
}

} // namespace

Json to_json(const Diagnosis& diagnosis, const std::string& version) {
    Json json = decision_of(diagnosis);
    json["library"] = library_of(diagnosis);
    json["isolability"] = isolability_of(diagnosis);
    if (diagnosis.gain)
        json["gain"] = gain_of_it(*diagnosis.gain);
    if (!diagnosis.beds.empty()) {
        json["beds"] = beds_of(diagnosis);
        json["degrees_of_freedom"] = diagnosis.evidence.degrees;
    }
    if (diagnosis.confirmation)
        json["confirmation"] = {{"amplitudes", diagnosis.confirmation->amplitudes}, {"p", diagnosis.confirmation->p}};
    Json proposals = Json::array();
    for (const Proposal& proposal : diagnosis.proposals)
        proposals.push_back({{"id", proposal.id},
                             {"sentence", proposal.sentence},
                             {"separation", proposal.separation},
                             {"separation_before", proposal.before},
                             {"repeats", proposal.repeats},
                             {"reached", proposal.reached}});
    json["experiments"] = std::move(proposals);
    Json nuisances = Json::array();
    for (const FittedNuisance& nuisance : diagnosis.nuisances) {
        nuisances.push_back({{"name", nuisance.name},
                             {"start", nuisance.start},
                             {"value", nuisance.value},
                             {"standard_error", number(nuisance.error)}});
        if (nuisance.extended)
            nuisances.back()["with_the_cause"] = *nuisance.extended;
    }
    json["nuisances"] = std::move(nuisances);
    Json measures;
    for (const auto& [measure, one] : diagnosis.noise.of)
        measures[measure] = {{"ratio", one.ratio}, {"correlation", one.correlation}};
    json["noise"] = {{"stated", diagnosis.noise.stated},   {"used", diagnosis.noise.used},
                     {"measures", std::move(measures)},    {"outliers", diagnosis.noise.left_out},
                     {"repeats", diagnosis.noise.repeats}, {"repeats_along_causes", diagnosis.noise.along},
                     {"widened", diagnosis.noise.widened}};
    json["readings"] = diagnosis.readings;
    json["chi_square_baseline"] = diagnosis.chi_square;
    Json warnings = Json::array();
    for (const Problem& warning : diagnosis.warnings)
        warnings.push_back(
            {{"name", warning.key}, {"file", warning.file}, {"what", warning.what}, {"fix", warning.fix}});
    json["warnings"] = std::move(warnings);
    json["settings"] = {
        {"alpha_gate", diagnosis.settings.alpha_gate}, {"alpha_adequacy", diagnosis.settings.alpha_adequacy},
        {"margin_nats", diagnosis.settings.margin},    {"rival_window_nats", diagnosis.settings.rival_window},
        {"same_class", diagnosis.settings.same_class}, {"fold_veto", diagnosis.settings.fold_veto}};
    json["title"] = diagnosis.title;
    json["scene"] = diagnosis.scene.string();
    json["data"] = diagnosis.data.string();
    json["data_hash"] = diagnosis.hash;
    json["scene_hash"] = diagnosis.scene_hash;
    json["sets"] = diagnosis.sets;
    json["runs"] = diagnosis.runs;
    if (!diagnosis.beds.empty())
        json["old_runs"] = diagnosis.old_runs;
    json["simulated_s"] = diagnosis.simulated;
    json["version"] = version;
    return json;
}

namespace {

std::string beds_csv(const Diagnosis& diagnosis) {
    std::string text = "condition,measure,unit,held_out,measured,measured_error,baseline,baseline_error,extended,"
                       "extended_error\n";
    for (const BedNumber& one : diagnosis.beds) {
        const std::vector<std::string> cells{one.condition,
                                             one.measure,
                                             one.unit,
                                             one.held_out ? "1" : "0",
                                             shortest(one.measured),
                                             shortest(one.measured_error),
                                             shortest(one.baseline),
                                             shortest(one.baseline_error),
                                             one.has_extended ? shortest(one.extended) : "",
                                             one.has_extended ? shortest(one.extended_error) : ""};
        text += csv_line(cells);
    }
    return text;
}

} // namespace

std::string residuals_csv(const Diagnosis& diagnosis) {
    if (!diagnosis.beds.empty())
        return beds_csv(diagnosis);
    std::string text = "record,column,time_s,measured,baseline,extended,residual_baseline,residual_extended,used\n";
    for (const Curve& curve : diagnosis.curves)
        for (std::size_t k = 0; k < curve.time.size(); ++k) {
            const double with = curve.extended.empty() ? curve.baseline[k] : curve.extended[k];
            const std::vector<std::string> cells{curve.record,
                                                 curve.unit.empty() ? curve.head : bare_head(curve) + "_" + curve.unit,
                                                 shortest(curve.time[k]),
                                                 shortest(curve.measured[k]),
                                                 shortest(curve.baseline[k]),
                                                 shortest(with),
                                                 shortest((curve.measured[k] - curve.baseline[k]) / curve.sigma),
                                                 shortest((curve.measured[k] - with) / curve.sigma),
                                                 curve.left_out[k] ? "0" : "1"};
            text += csv_line(cells);
        }
    return text;
}

} // namespace tumble::report
