#include "report/diagnosis_page.h"

#include "base/text.h"
#include "diagnose/verdict.h"
#include "observe/measures.h"
#include "report/bed_section.h"
#include "report/residual_plots.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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
table{border-collapse:collapse;font-size:.85em}td,th{padding:.2em .6em;border:1px solid #ddd;text-align:left}
td.n{text-align:right;font-variant-numeric:tabular-nums}th.r{writing-mode:vertical-rl;transform:rotate(180deg);padding:.6em .2em}
svg{max-width:100%;height:auto}.plots{display:flex;flex-wrap:wrap;gap:12px}
)";

std::string axis_of(const Curve& curve) {
    return curve.unit.empty() ? curve.head
                              : fmt::format("{} [{}]", bare_head(curve), observe::spelled_unit(curve.unit));
}

std::string measured_section(const Diagnosis& diagnosis) {
    std::string out = "<h2>What was measured, and what the scene gives</h2><p>On this scale a difference of some "
                      "standard errors does not show; the residuals below are what counts.</p><div class=\"plots\">";
    for (const Curve& curve : diagnosis.curves) {
        if (curve.unit == "s") // a clock in the picture: a straight line
            continue;
        Plot plot{.title = curve.record,
                  .x_label = "time [s]",
                  .y_label = axis_of(curve),
                  .traces = {},
                  .levels = {},
                  .band = {},
                  .y_range = {},
                  .width = 460,
                  .height = 230};
        plot.traces.push_back({.label = "measured", .x = curve.time, .y = curve.measured, .color = "#444444"});
        plot.traces.push_back(
            {.label = "baseline", .x = curve.time, .y = curve.baseline, .color = color_of(1), .line = true});
        if (!curve.extended.empty())
            plot.traces.push_back({.label = second_explanation(diagnosis),
                                   .x = curve.time,
                                   .y = curve.extended,
                                   .color = color_of(0),
                                   .line = true,
                                   .dashed = true});
        out += svg_of(plot);
    }
    return out + "</div>";
}

std::string residual_section(const Diagnosis& diagnosis) {
    std::string out = "<h2>What the scene leaves unexplained</h2><p>Residual = measured less baseline, in standard "
                      "errors of a reading; 95 % of pure noise lies in the grey band. Colours are conditions; lone "
                      "outliers are not drawn.</p><div class=\"plots\">";
    for (const std::string& plot : residual_plots(diagnosis))
        out += plot;
    return out + "</div>";
}

std::string library_section(const Diagnosis& diagnosis) {
    std::vector<Bar> bars;
    const Decision& decision = diagnosis.decision;
    double best = 0;
    std::map<std::string, std::string> silent; // causes by why they do not show
    for (std::size_t k = 0; k < decision.seen.size(); ++k) {
        const Seen& seen = decision.seen[k];
        if (!seen.visible) {
            std::string& ids = silent[standing_of(diagnosis, static_cast<int>(k))];
            ids += (ids.empty() ? "" : ", ") + diagnosis.causes[k].id;
            continue;
        }
        const bool named =
            std::find(decision.causes.begin(), decision.causes.end(), static_cast<int>(k)) != decision.causes.end();
        best = std::max(best, seen.gain);
        bars.push_back({diagnosis.causes[k].id, standing_of(diagnosis, static_cast<int>(k)),
                        named ? color_of(1) : "#9db4c4", seen.gain});
    }
    std::vector<Mark> marks{{decision.gate, "gate"}};
    if (best > decision.gate)
        marks.push_back({std::max(0.0, gain_behind(diagnosis.evidence, best, diagnosis.settings.margin)), "margin"});
    std::string rest;
    for (const auto& [why, ids] : silent)
        rest += fmt::format(" {}: {}.", ids, why);
    return fmt::format(
        "<h2>How far each cause of the library explains it</h2>{}<p class=\"small\">Noise alone drives the "
        "best of all causes beyond the gate in {:g} % of cases; whoever lies beyond the margin cannot be "
        "told from the best.{}</p>",
        bars.empty() ? "" : svg_of(bars, marks, "fall of chi-square when the cause is added"),
        100 * diagnosis.settings.alpha_gate, rest);
}

std::string shade(double left) {
    const int grey = static_cast<int>(255 - 110 * (1 - std::clamp(left, 0.0, 1.0)));
    return fmt::format("background:rgb(255,{0},{0})", grey);
}

std::string isolability_section(const Diagnosis& diagnosis) {
    const MatrixXd& left = diagnosis.decision.isolability;
    std::string head, body;
    for (Eigen::Index i = 0; i < left.rows(); ++i) {
        if (std::isnan(left(i, i)))
            continue;
        const std::string id = diagnosis.causes[static_cast<std::size_t>(i)].id;
        head += fmt::format("<th class=\"r\">{}</th>", id);
        body += fmt::format("<tr><th>{}</th>", id);
        for (Eigen::Index j = 0; j < left.cols(); ++j)
            if (!std::isnan(left(j, j)))
                body += i == j ? "<td></td>"
                               : fmt::format("<td class=\"n\" style=\"{}\">{:.2f}</td>", shade(left(i, j)), left(i, j));
        body += "</tr>";
    }
    if (body.empty())
        return "";
    return fmt::format(
        "<h2>What these data can tell apart</h2><p>Share of the row's effect that is left when the column's "
        "cause is fitted in its place: 0 is the same answer, 1 cannot be mistaken. Causes that these data do "
        "not show are not listed.</p><table><tr><th></th>{}</tr>{}</table>",
        head, body);
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
        text, gain.shown ? "The gain is shown" : "The gain is not shown: some conditions do not improve",
        gain.held_out ? "held out" : "condition left out", diagnosis.beds.empty() ? "readings" : "numbers", rows,
        diagnosis.beds.empty()
            ? " What only a record can tell, its clock say, is left as open as it was beforehand, for both alike."
            : "");
}

std::string fingerprint_section(const Diagnosis& diagnosis) {
    std::string items;
    for (const int k : diagnosis.decision.causes) {
        const Cause& cause = diagnosis.causes[static_cast<std::size_t>(k)];
        items += fmt::format("<li><b>{}</b>, {}: {}. <span class=\"small\">Sets: {}.</span></li>", cause.id,
                             escaped(cause.name), escaped(cause.look), escaped(cause.keys));
    }
    std::string text = items.empty() ? "" : "<h2>What to look for in the residual</h2><ul>" + items + "</ul>";
    const Following& follows = diagnosis.follows;
    if (follows.all.empty())
        return text;
    items.clear();
    for (const Followed& one : follows.all)
        items += fmt::format("<tr><td>{}</td><td class=\"n\">{:+.1f}</td></tr>", escaped(one.what), one.z);
    return text +
           fmt::format(
               "<h2>What the residual follows</h2><p>Directions that belong to no particular cause, and how "
               "far what {} leaves goes along each. {} directions were tried; noise alone takes it {:.1f} standard "
               "errors along any of them in 0.27 % of cases, and less is not listed.</p><table><tr>"
               "<th>direction</th><th>standard errors</th></tr>{}</table>",
               diagnosis.decision.best ? "the best explanation" : "the scene", follows.tried, follows.gate, items);
}

std::string plan_section(const Diagnosis& diagnosis) {
    if (diagnosis.proposals.empty())
        return "";
    std::string rows;
    for (const Proposal& proposal : diagnosis.proposals)
        rows += fmt::format("<tr><td>{}</td><td class=\"n\">{:.1f}</td><td class=\"n\">{}</td></tr>",
                            escaped(proposal.sentence), proposal.separation,
                            proposal.repeats == 0 ? "never" : std::to_string(proposal.repeats));
    return "<h2>What to measure next</h2><table><tr><th>experiment</th><th>standard errors apart</th><th>repeats to "
           "reach 5"
           "</th></tr>" +
           rows + "</table>";
}

/// 0.31; or, where there are several measures, 0.31 (centre_of_mass_y), 0.02 (time).
std::string correlations_of(const Diagnosis& diagnosis) {
    std::string all;
    for (const auto& [measure, one] : diagnosis.noise.of)
        all += fmt::format("{}{:.2f}{}", all.empty() ? "" : ", ", one.correlation,
                           diagnosis.noise.of.size() > 1 ? fmt::format(" ({})", measure) : "");
    return all;
}

std::string small_print(const Diagnosis& diagnosis, const std::string& version) {
    std::string rows;
    for (const FittedNuisance& nuisance : diagnosis.nuisances)
        rows += fmt::format("<tr><td>{}</td><td class=\"n\">{:.6g}</td><td class=\"n\">{:.4g} &plusmn; {:.1g}</td>"
                            "<td class=\"n\">{}</td></tr>",
                            escaped(nuisance.name), nuisance.start, nuisance.value, nuisance.error,
                            nuisance.extended ? fmt::format("{:.4g}", *nuisance.extended) : "");
    std::map<std::string, std::string> files; // of each sentence
    for (const Problem& warning : diagnosis.warnings) {
        const std::string sentence =
            fmt::format("<b>{}</b>: {}; {}.", escaped(warning.key), escaped(warning.what), escaped(warning.fix));
        files[sentence] +=
            (files[sentence].empty() ? "" : ", ") + escaped(std::filesystem::path(warning.file).filename().string());
    }
    std::string warnings;
    for (const auto& [sentence, names] : files)
        warnings += fmt::format("<li>{} <span class=\"small\">({})</span></li>", sentence, names);
    if (!diagnosis.beds.empty())
        return bed_small_print(diagnosis, warnings, version);
    return fmt::format(
        "<h2>Small print</h2>{}<table><tr><th>adjusted under every explanation (SI)</th><th>in the "
        "scene</th><th>fitted, "
        "baseline</th><th>with what is named</th></tr>{}</table><p class=\"small\">{} readings, scatter {:.3g} "
        "(stated: {}); errors of "
        "neighbouring readings correlate by {}. Adequacy of the baseline p = {:.2g}, of the extension p = {:.2g}. {} "
        "runs, {:.3g} s simulated. Scene "
        "{}, "
        "data {} ({}). tumble {}.</p>",
        warnings.empty() ? "" : "<ul>" + warnings + "</ul>", rows, diagnosis.readings, diagnosis.noise.used,
        diagnosis.noise.stated > 0 ? fmt::format("{:.3g}", diagnosis.noise.stated) : "no", correlations_of(diagnosis),
        diagnosis.decision.baseline.p(), diagnosis.decision.winner.p(), diagnosis.runs, diagnosis.simulated,
        escaped(diagnosis.scene.string()), escaped(diagnosis.data.string()), diagnosis.hash, version);
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
    page += diagnosis.beds.empty() ? measured_section(diagnosis) + residual_section(diagnosis) : bed_section(diagnosis);
    page += fingerprint_section(diagnosis) + library_section(diagnosis) + plan_section(diagnosis) +
            gain_section(diagnosis) + isolability_section(diagnosis) + small_print(diagnosis, version);
    return page + "</body></html>\n";
}

} // namespace tumble::report
