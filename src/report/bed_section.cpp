#include "report/bed_section.h"

#include "observe/measures.h"
#include "report/interval_plot.h"
#include "report/measured_words.h"
#include "report/svg_plot.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr double two_sided_95 = 1.96; // standard errors

double apart(const BedNumber& one, double value, double error) {
    return (one.measured - value) / std::hypot(one.measured_error, error);
}

std::string error_cell(double value, double error) {
    return "<td class=\"n\">" + with_error(value, error) + "</td>";
}

std::string apart_cell(double z) {
    return "<td class=\"n\">" + with_minus(fmt::format("{:+.1f}", z)) + "</td>";
}

std::string row_of(const BedNumber& one) {
    std::string row = fmt::format("<tr><td>{}{}</td><td>{}{}</td>", escaped(one.condition),
                                  one.held_out ? " (held out)" : "", observe::spelled_name(one.measure),
                                  one.unit.empty() ? "" : " [" + observe::spelled_unit(one.unit) + "]");
    row += error_cell(one.measured, one.measured_error) + error_cell(one.baseline, one.baseline_error) +
           apart_cell(apart(one, one.baseline, one.baseline_error));
    if (one.has_extended)
        row += error_cell(one.extended, one.extended_error) + apart_cell(apart(one, one.extended, one.extended_error));
    return row + fmt::format("<td class=\"n\">{:.2g}</td></tr>", one.scatter);
}

/// What "extended" is, and whether its own runs are what the table foretold.
std::string confirmed_words(const Diagnosis& diagnosis) {
    const auto& best = diagnosis.decision.best;
    if (!diagnosis.confirmation || !best)
        return "";
    std::string at;
    for (std::size_t k = 0; k < best->causes.size() && k < diagnosis.confirmation->amplitudes.size(); ++k) {
        const Cause& cause = diagnosis.causes[static_cast<std::size_t>(best->causes[k])];
        at +=
            fmt::format("{}{} at {:.4g}{}", at.empty() ? "" : " and ", cause.id, diagnosis.confirmation->amplitudes[k],
                        cause.unit.empty() ? "" : " " + observe::spelled_unit(cause.unit));
    }
    return fmt::format(" Extended: the scene with {}, run with seeds of its own; so large a difference from what the "
                       "response table foretold has p = {:.2g}.",
                       at, diagnosis.confirmation->p);
}

} // namespace

std::string plot_of(const BedNumber& one) {
    std::vector<Interval> intervals{{"measured", "#444444", one.measured, two_sided_95 * one.measured_error},
                                    {"baseline", color_of(1), one.baseline, two_sided_95 * one.baseline_error}};
    if (one.has_extended)
        intervals.push_back({"extended", color_of(0), one.extended, two_sided_95 * one.extended_error});
    const std::string unit = observe::spelled_unit(one.unit);
    return svg_of(fmt::format("{}{}", one.condition, one.held_out ? ", held out" : ""), intervals,
                  observe::spelled_name(one.measure) + (unit.empty() ? "" : " [" + unit + "]"));
}

std::string bed_section(const Diagnosis& diagnosis) {
    std::string plots, rows;
    bool extended = false;
    for (const BedNumber& one : diagnosis.beds) {
        plots += plot_of(one);
        rows += row_of(one);
        extended = extended || one.has_extended;
    }
    const std::string confirmed = confirmed_words(diagnosis);
    return fmt::format(
        "<h2>What was measured of the bed, and what the scene gives</h2><p>Means over time and runs; bars hold 95 %. "
        "Paths in a bed do not repeat, so only means are compared.{}</p><div class=\"plots\">{}</div><table><tr><th>"
        "condition</th><th>number</th><th>measured</th><th>baseline</th><th>off by</th>{}<th>scatter of one run</th>"
        "</tr>{}</table><p class=\"small\">&plusmn;: standard error. Off by: measured less simulated, in standard "
        "errors "
        "of the difference. The scatter is the simulation's, from run to run.</p>",
        confirmed, plots, extended ? "<th>extended</th><th>off by</th>" : "", rows);
}

std::string bed_small_print(const Diagnosis& diagnosis, const std::string& warnings, const std::string& version) {
    std::string innocent;
    for (const FittedNuisance& nuisance : diagnosis.nuisances)
        innocent +=
            fmt::format("<tr><td>{}</td>{}</tr>", escaped(nuisance.name), error_cell(nuisance.value, nuisance.error));
    if (!innocent.empty())
        innocent = "<table><tr><th>adjusted under every explanation</th><th>fitted, baseline</th></tr>" + innocent +
                   "</table>";
    return fmt::format(
        "<h2>Small print</h2>{}{}<p class=\"small\">{} numbers of {} seeds each; their scatter is known with {:.0f} "
        "degrees of freedom, from all runs of the response table together. Adequacy of the baseline p = {:.2g}{} "
        "(Hotelling's T squared). Causes were run at two amplitudes each and are read between them, which the runs at "
        "the fitted value check. {} runs now, {:.4g} s simulated. Scene {}, data {} ({}). tumble {}.</p>",
        warnings, innocent, diagnosis.readings, diagnosis.beds.empty() ? 0 : diagnosis.beds[0].seeds,
        diagnosis.evidence.degrees, diagnosis.decision.baseline.p(),
        diagnosis.decision.best ? fmt::format(", of the best explanation p = {:.2g}", diagnosis.decision.winner.p())
                                : "",
        diagnosis.runs, diagnosis.simulated, scene_words(diagnosis), escaped(diagnosis.data.string()), diagnosis.hash,
        version);
}

} // namespace tumble::report
