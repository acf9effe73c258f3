#include "report/diagnosis_page.h"

#include "diagnose/verdict.h"
#include "report/bed_section.h"
#include "report/cause_section.h"
#include "report/fingerprint_section.h"
#include "report/measured_words.h"
#include "report/record_section.h"
#include "report/residual_plots.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr const char* style = R"(
body{font:16px/1.5 "DejaVu Sans",Verdana,sans-serif;max-width:960px;margin:2em auto;padding:0 1em;color:#222}
h1{font-size:1.4em;margin:0 0 .2em}h2{font-size:1.1em;margin:2em 0 .4em;border-bottom:1px solid #ccc}
.verdict{background:#f2f6fa;border-left:6px solid #0072B2;padding:.8em 1em;margin:1em 0}
.verdict.bad{background:#fdf3ec;border-color:#D55E00}.verdict.good{background:#eef8f3;border-color:#009E73}
.verdict b{letter-spacing:.04em}.small{font-size:.85em;color:#555}
table{border-collapse:collapse;font-size:.85em}td,th{padding:.2em .5em;border:1px solid #ddd;text-align:left}
td.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}th.r{writing-mode:vertical-rl;transform:rotate(180deg);padding:.6em .2em}
svg{max-width:100%;height:auto}.plots{display:flex;flex-wrap:wrap;gap:12px;margin:.6em 0}
h3{font-size:1em;margin:1.2em 0 .2em}table{margin:.6em 0}.wide{overflow-x:auto}summary{cursor:pointer;font-size:.85em}
@media print{.plots,svg,tr{break-inside:avoid}body{margin:0}}
)";

/// "drag.linear, drag.quadratic", or "drag.linear with ins.gain, ...": those that an experiment should part.
std::string ids_to_part(const Diagnosis& diagnosis) {
    std::vector<std::string> all;
    for (const std::vector<int>& rival : rivals_in(diagnosis.decision)) {
        std::vector<std::string> ids;
        for (const int k : rival)
            ids.push_back(escaped(diagnosis.causes[static_cast<std::size_t>(k)].id));
        all.push_back(fmt::format("{}", fmt::join(ids, " with ")));
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string gain_section(const Diagnosis& diagnosis) {
    if (!diagnosis.gain)
        return "";
    const Gain& gain = *diagnosis.gain;
    std::string rows;
    for (const Score& score : gain.scores)
        rows += fmt::format(
            "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2f}</td><td class=\"n\">{:.2f}</td></tr>",
            escaped(score.condition), score.readings, std::sqrt(score.baseline / std::max(1, score.readings)),
            std::sqrt(score.extended / std::max(1, score.readings)));
    std::string text =
        fmt::format("{:.0f} % of the misfit that any model could remove is gone; log score rises by {:.1f} nats",
                    100 * gain.share_removed, gain.nats);
    if (gain.bootstrapped)
        text += fmt::format(" (95 %: {:.1f} to {:.1f})", gain.nats_low, gain.nats_high);
    return fmt::format(
        "<h2>What the extension is worth where it was not fitted</h2><p>{}. {}.</p><table><tr><th>{}</th><th>{}"
        "</th><th>baseline</th><th>extended</th></tr>{}</table><p class=\"small\">Root mean square residual in "
        "standard errors; 1 is noise alone.{}</p>",
        text,
        gain.shown          ? "The gain is shown"
        : gain.bootstrapped ? "The gain is not shown: the interval does not lie above 0"
                            : "The gain is not shown: some condition that the cause acts on does not improve, or all "
                              "together by less than 3 nats",
        gain.held_out ? "held out" : "condition left out", diagnosis.beds.empty() ? "readings" : "numbers", rows,
        diagnosis.beds.empty()
            ? " What only a record can tell, its clock say, is left as open as it was beforehand, for both alike."
            : "");
}

std::string plan_section(const Diagnosis& diagnosis) {
    if (diagnosis.proposals.empty())
        return "";
    std::string rows;
    for (const Proposal& proposal : diagnosis.proposals)
        rows += fmt::format("<tr><td>{}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{:.1f}</td><td "
                            "class=\"n\">{}</td></tr>",
                            escaped(proposal.sentence), proposal.before, proposal.separation,
                            proposal.before >= told_apart ? "reached"
                            : proposal.repeats == 0       ? "over 1000"
                                                          : std::to_string(proposal.repeats));
    return fmt::format(
        "<h2>What to measure next</h2><p>How far each experiment, added to what was measured, would set "
        "the nearest two of {} apart, and how often it would have to be made to reach 5 standard errors. "
        "Most telling first.</p><table><tr><th>experiment</th><th>standard errors apart now</th><th>with "
        "it</th><th>times to reach 5</th></tr>{}</table>",
        ids_to_part(diagnosis), rows);
}

std::string warning_list(const Diagnosis& diagnosis) {
    std::map<std::string, std::string> files; // of each sentence
    for (const Problem& warning : diagnosis.warnings) {
        const std::string sentence =
            fmt::format("<b>{}</b>: {}; {}.", escaped(warning.key), escaped(warning.what), escaped(warning.fix));
        const std::string file = escaped(std::filesystem::path(warning.file).filename().string());
        std::string& all = files[sentence];
        all += (all.empty() || file.empty() ? "" : ", ") + file;
    }
    std::string items;
    for (const auto& [sentence, names] : files)
        items += fmt::format("<li>{}{}</li>", sentence,
                             names.empty() ? "" : " <span class=\"small\">(" + names + ")</span>");
    return items.empty() ? "" : "<ul>" + items + "</ul>";
}

std::string nuisance_table(const Diagnosis& diagnosis) {
    const bool named = std::any_of(diagnosis.nuisances.begin(), diagnosis.nuisances.end(),
                                   [](const FittedNuisance& nuisance) { return nuisance.extended.has_value(); });
    std::string rows;
    for (const FittedNuisance& nuisance : diagnosis.nuisances) {
        const auto with = nuisance.extended ? fmt::format("{:.4g}", *nuisance.extended) : std::string();
        rows +=
            fmt::format("<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>{}</tr>", escaped(nuisance.name),
                        with_minus(fmt::format("{:.6g}", nuisance.start)), with_error(nuisance.value, nuisance.error),
                        named ? "<td class=\"n\">" + with_minus(with) + "</td>" : "");
    }
    if (rows.empty())
        return "";
    return fmt::format("<table><tr><th>adjusted under every explanation (SI)</th><th>in the scene</th><th>fitted, "
                       "baseline</th>{}</tr>{}</table>",
                       named ? fmt::format("<th>{}</th>", escaped(second_explanation(diagnosis))) : "", rows);
}

std::string adequacy_words(const Decision& decision) {
    if (decision.seen.empty())
        return "";
    return fmt::format(" Adequacy of the baseline p = {:.2g}{}.", decision.baseline.p(),
                       decision.best ? fmt::format(", of the best explanation p = {:.2g}", decision.winner.p()) : "");
}

std::string small_print(const Diagnosis& diagnosis, const std::string& version) {
    const std::string warnings = warning_list(diagnosis);
    if (!diagnosis.beds.empty())
        return bed_small_print(diagnosis, warnings, version);
    return fmt::format("<h2>Small print</h2>{}{}{}<p class=\"small\">{} readings.{} {} runs, {:.4g} s simulated. Scene "
                       "{}, data {} ({}). tumble {}.</p>",
                       warnings, scatter_table(diagnosis), nuisance_table(diagnosis), diagnosis.readings,
                       adequacy_words(diagnosis.decision), diagnosis.runs, diagnosis.simulated, scene_words(diagnosis),
                       escaped(diagnosis.data.string()), diagnosis.hash, version);
}

/// "+-" as a page has it.
std::string with_sign(std::string text) {
    for (std::size_t at = text.find("+-"); at != std::string::npos; at = text.find("+-", at))
        text.replace(at, 2, "&plusmn;");
    return text;
}

} // namespace

std::string page_of(const Diagnosis& diagnosis, const std::string& version) {
    const Outcome outcome = diagnosis.decision.outcome;
    const bool found = diagnosis.decision.sure && (outcome == Outcome::named || outcome == Outcome::two_causes);
    const char* mood = outcome == Outcome::consistent ? "good" : found ? "" : "bad";
    std::string page = fmt::format(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>{}</title><style>{}{}</style></head>"
        "<body><h1>{}</h1><div class=\"verdict {}\"><b>{}</b><p>{}</p><p>{}</p></div>",
        escaped(diagnosis.title), style, plot_style, escaped(diagnosis.title), mood, outcome_words(diagnosis),
        with_sign(escaped(verdict_of(diagnosis))), with_sign(escaped(next_step(diagnosis))));
    page += diagnosis.beds.empty() ? record_section(diagnosis) : bed_section(diagnosis);
    page += plan_section(diagnosis) + cause_section(diagnosis) + fingerprint_section(diagnosis) +
            gain_section(diagnosis) + isolability_section(diagnosis) + small_print(diagnosis, version);
    return page + "</body></html>\n";
}

} // namespace tumble::report
