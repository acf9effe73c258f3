#include "report/fingerprint_section.h"

#include "diagnose/fingerprints.h"
#include "report/measured_words.h"
#include "report/residual_plots.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr std::size_t most_shown = 3; // causes that are explained
constexpr double hardly_alike = 0.5;  // of an effect: below it no direction is like it

/// "speed" of "speed (centre_of_mass_y)"; the measure, or nothing.
std::pair<std::string, std::string> parted(const std::string& what) {
    const std::size_t at = what.rfind(" (");
    if (at == std::string::npos || !what.ends_with(')'))
        return {what, ""};
    return {what.substr(0, at), what.substr(at + 2, what.size() - at - 3)};
}

std::string z_words(const std::optional<Along>& along) {
    return along ? with_minus(fmt::format("{:+.1f}", along->z)) : "&ndash;";
}

/// Its slope with standard error and unit; a dash where nuisances take the direction up.
std::string slope_words(const std::optional<Along>& along, const std::string& unit) {
    if (!along || std::isnan(along->slope))
        return "&ndash;";
    return with_error(along->slope, along->error) + (unit.empty() ? "" : " " + escaped(unit));
}

bool beyond(const std::optional<Along>& along, double gate) {
    return along && std::abs(along->z) >= gate;
}

std::string stamp_of(const Fingerprint& print, bool has_best, double gate) {
    if (beyond(print.scene, gate))
        return !has_best ? "<b>FOLLOWS</b>" : beyond(print.best, gate) ? "<b>STILL FOLLOWS</b>" : "follows, then gone";
    if (beyond(print.best, gate))
        return "<b>FOLLOWS NOW</b>";
    return print.scene ? "no" : "nothing of it is left here";
}

std::string row_of_print(const Fingerprint& print, const std::string& words, bool slopes, bool has_best, double gate) {
    const auto cells = [&](const std::optional<Along>& along) {
        return (slopes ? fmt::format("<td class=\"n\">{}</td>", slope_words(along, print.unit)) : "") +
               fmt::format("<td class=\"n\">{}</td>", z_words(along));
    };
    return fmt::format("<tr><td>{}</td>{}{}<td>{}</td></tr>", escaped(words), cells(print.scene),
                       has_best ? cells(print.best) : "", stamp_of(print, has_best, gate));
}

/// Rows of one measure under one head; of what would differ in one condition alone only those beyond the gate.
std::string table_of_prints(const Diagnosis& diagnosis, const std::vector<Fingerprint>& prints,
                            const std::string& measure, const std::string& second) {
    const bool has_best = !second.empty();
    const double gate = diagnosis.follows.gate;
    const bool slopes = diagnosis.evidence.directions.lengths.size() > 0;
    std::string rows;
    for (const Fingerprint& print : prints) {
        const auto [words, whose] = parted(print.what);
        const bool quiet = !beyond(print.scene, gate) && !beyond(print.best, gate);
        if (whose == measure && !(print.of_condition && quiet))
            rows += row_of_print(print, words, slopes, has_best, gate);
    }
    if (rows.empty())
        return "";
    const std::string pair = slopes ? "<th>slope</th><th>standard errors</th>" : "<th>standard errors</th>";
    return fmt::format("<table><tr><th rowspan=\"2\">{0}</th><th colspan=\"{1}\">baseline</th>{2}<th "
                       "rowspan=\"2\">follows?</th></tr><tr>{3}{4}</tr>{5}</table>",
                       measure.empty() ? "direction" : escaped(measure), slopes ? 2 : 1,
                       has_best ? fmt::format("<th colspan=\"{}\">{}</th>", slopes ? 2 : 1, escaped(second)) : "", pair,
                       has_best ? pair : "", rows);
}

std::string tables_of_prints(const Diagnosis& diagnosis, const std::vector<Fingerprint>& prints) {
    const std::string second = second_explanation(diagnosis);
    std::vector<std::string> measures;
    int quiet = 0;
    for (const Fingerprint& print : prints) {
        const std::string whose = parted(print.what).second;
        if (std::find(measures.begin(), measures.end(), whose) == measures.end())
            measures.push_back(whose);
        quiet += print.of_condition && !beyond(print.scene, diagnosis.follows.gate) &&
                 !beyond(print.best, diagnosis.follows.gate);
    }
    std::string tables, folded;
    for (const std::string& measure : measures) {
        const bool loud = std::any_of(prints.begin(), prints.end(), [&](const Fingerprint& print) {
            return parted(print.what).second == measure &&
                   (beyond(print.scene, diagnosis.follows.gate) || beyond(print.best, diagnosis.follows.gate));
        });
        (loud || measure == measures[0] ? tables : folded) += table_of_prints(diagnosis, prints, measure, second);
    }
    if (!folded.empty())
        tables += fmt::format("<details><summary>Measures of which the residual follows nothing</summary>{}</details>",
                              folded);
    if (quiet > 0)
        tables += fmt::format("<p class=\"small\">{} further directions, of one condition alone each, stay within the "
                              "gate and are not listed.</p>",
                              quiet);
    return tables;
}

/// Where nothing impacts a direction that counts impacts is another's twin; the first of them is enough.
bool is_twin(const MatrixXd& prints, Eigen::Index k) {
    constexpr double same = 1 - 1e-9;
    for (Eigen::Index j = 0; j < k; ++j)
        if (std::abs(prints.col(j).dot(prints.col(k))) > same)
            return true;
    return false;
}

std::vector<Fingerprint> without_twins(const Diagnosis& diagnosis, const std::vector<Fingerprint>& prints) {
    std::vector<Fingerprint> kept;
    for (std::size_t k = 0; k < prints.size(); ++k)
        if (prints[k].of_condition || !is_twin(diagnosis.evidence.directions.prints, static_cast<Eigen::Index>(k)))
            kept.push_back(prints[k]);
    return kept;
}

/// "Of its effect 98 % goes along ...": what a reader can hold against the table.
std::string because(const Diagnosis& diagnosis, const std::vector<Fingerprint>& prints, int cause) {
    auto like = likest(diagnosis.evidence, cause, false);
    if (!like || like->share < hardly_alike)
        like = likest(diagnosis.evidence, cause);
    if (!like || !prints[like->direction].scene)
        return "";
    const Fingerprint& print = prints[like->direction];
    if (like->share < hardly_alike)
        return " No single direction of the table is like its effect.";
    return fmt::format(
        " Of its effect {:.0f} % goes along <i>{}</i>, along which the baseline's residual goes by {} standard "
        "errors{}.",
        100 * like->share, escaped(print.what), z_words(print.scene),
        print.best ? fmt::format(", and by {} {}", z_words(print.best), escaped(second_explanation(diagnosis))) : "");
}

std::string suspects_of(const Diagnosis& diagnosis, const std::vector<Fingerprint>& prints) {
    const Decision& decision = diagnosis.decision;
    std::vector<int> causes = decision.causes;
    if (causes.empty() && decision.best)
        causes = decision.best->causes;
    std::string items;
    for (std::size_t i = 0; i < std::min(causes.size(), most_shown); ++i) {
        const Cause& cause = diagnosis.causes[static_cast<std::size_t>(causes[i])];
        items += fmt::format("<li><b>{}</b>, {}: {}.{} <span class=\"small\">Sets: {}.</span></li>", cause.id,
                             escaped(cause.name), escaped(cause.look),
                             prints.empty() ? "" : because(diagnosis, prints, causes[i]), escaped(cause.keys));
    }
    if (items.empty())
        return "";
    const char* head = decision.outcome == Outcome::none_known  ? "What comes nearest, and what does not fit"
                       : decision.outcome == Outcome::ambiguous ? "What it looks like, and why it may be either"
                                                                : "What it looks like, and why";
    const std::string more = causes.size() > most_shown
                                 ? fmt::format("<p class=\"small\">{} more may be it.</p>", causes.size() - most_shown)
                                 : "";
    return fmt::format("<h2>{}</h2><ul>{}</ul>{}", head, items, more);
}

/// A swing is no direction of the table.
std::string swings_of(const Diagnosis& diagnosis) {
    std::string words;
    for (const Followed& one : diagnosis.follows.all)
        if (one.what.starts_with("a swing"))
            words += fmt::format("<p>What is left follows {}, by as much as {:.1f} standard errors.</p>",
                                 escaped(one.what), std::abs(one.z));
    return words;
}

} // namespace

std::string fingerprint_section(const Diagnosis& diagnosis) {
    const std::vector<Fingerprint> prints = fingerprints_of(diagnosis.evidence, diagnosis.decision);
    const std::string suspects = suspects_of(diagnosis, prints);
    if (prints.empty())
        return suspects;
    return suspects +
           fmt::format("<h2>What the residual follows</h2><p>{} along directions that belong to no "
                       "particular cause, each by itself, with everything that was fitted adjusted (&plusmn;: standard "
                       "error). {} directions were tried; noise alone takes the residual {:.1f} standard errors along "
                       "any of them in 0.27 % of cases: only beyond that it follows.</p>{}{}",
                       diagnosis.evidence.directions.lengths.size() > 0 ? "Slope of the residual"
                                                                        : "How far the residual goes",
                       diagnosis.follows.tried, diagnosis.follows.gate, swings_of(diagnosis),
                       tables_of_prints(diagnosis, without_twins(diagnosis, prints)));
}

} // namespace tumble::report
