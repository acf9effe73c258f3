#include "report/record_section.h"

#include "observe/measures.h"
#include "report/measured_words.h"
#include "report/residual_plots.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr std::size_t most_records = 12; // plots of what was measured
constexpr const char* measured_colour = "#b0b0b0";

std::string plot_of_record(const Curve& curve, const std::string& second) {
    Plot plot{.title = curve.record,
              .x_label = "time [s]",
              .y_label = column_name(curve),
              .traces = {},
              .levels = {},
              .band = {},
              .y_range = {},
              .width = 460,
              .height = 230};
    plot.traces.push_back({.label = "measured", .x = curve.time, .y = curve.measured, .color = measured_colour});
    plot.traces.push_back(
        {.label = "baseline", .x = curve.time, .y = curve.baseline, .color = color_of(1), .line = true});
    if (!curve.extended.empty())
        plot.traces.push_back({.label = second,
                               .x = curve.time,
                               .y = curve.extended,
                               .color = color_of(0),
                               .line = true,
                               .dashed = true});
    return svg_of(plot);
}

/// Those that are drawn: all, or where they are too many first one of each condition and column.
std::vector<const Curve*> chosen_records(const std::vector<const Curve*>& all) {
    if (all.size() <= most_records)
        return all;
    std::vector<const Curve*> chosen;
    std::vector<std::string> known;
    for (const bool again : {false, true})
        for (const Curve* curve : all) {
            const std::string kind = curve->condition + "\n" + curve->head;
            const bool is_new = std::find(known.begin(), known.end(), kind) == known.end();
            const bool taken = std::find(chosen.begin(), chosen.end(), curve) != chosen.end();
            if (chosen.size() < most_records && !taken && (again || is_new)) {
                chosen.push_back(curve);
                known.push_back(kind);
            }
        }
    std::sort(chosen.begin(), chosen.end(), [&](const Curve* a, const Curve* b) { return a < b; });
    return chosen;
}

std::string measured_records(const Diagnosis& diagnosis) {
    std::vector<const Curve*> curves;
    for (const Curve& curve : diagnosis.curves)
        if (!is_number(curve) && curve.unit != "s") // a clock in the picture: a straight line
            curves.push_back(&curve);
    if (curves.empty())
        return "";
    std::string plots;
    const std::vector<const Curve*> chosen = chosen_records(curves);
    for (const Curve* curve : chosen)
        plots += plot_of_record(*curve, second_explanation(diagnosis));
    const std::string more =
        curves.size() > chosen.size()
            ? fmt::format(" {} of {} records are drawn; residuals.csv has all.", chosen.size(), curves.size())
            : "";
    return fmt::format("<p>Baseline: the scene as it is written, with what is innocent adjusted. On this scale a "
                       "difference of some standard errors does not show; the residuals below are "
                       "what counts.{}</p><div class=\"plots\">{}</div>",
                       more, plots);
}

std::string cell(const std::string& text) {
    return "<td class=\"n\">" + text + "</td>";
}

/// In standard errors of a reading.
std::string off_by(const Curve& curve, double simulated) {
    return cell(with_minus(fmt::format("{:+.1f}", (curve.measured[0] - simulated) / curve.sigma)));
}

/// Single numbers, one of each record.
std::string measured_numbers(const Diagnosis& diagnosis) {
    std::string rows;
    bool extended = false;
    for (const Curve& curve : diagnosis.curves) {
        if (!is_number(curve) || curve.time.empty())
            continue;
        rows +=
            fmt::format("<tr><td>{}</td><td>{}</td>{}{}{}", escaped(curve.record), escaped(column_name(curve)),
                        cell(with_error(curve.measured[0], curve.sigma)),
                        cell(with_minus(fmt::format("{:.5g}", curve.baseline[0]))), off_by(curve, curve.baseline[0]));
        if (!curve.extended.empty()) {
            extended = true;
            rows += cell(with_minus(fmt::format("{:.5g}", curve.extended[0]))) + off_by(curve, curve.extended[0]);
        }
        rows += "</tr>";
    }
    if (rows.empty())
        return "";
    return fmt::format(
        "<table><tr><th>record</th><th>number</th><th>measured</th><th>baseline</th><th>off by</th>{}</tr>{}"
        "</table><p class=\"small\">&plusmn;: standard error of one number. Off by: measured less "
        "simulated, in standard errors.</p>",
        extended ? fmt::format("<th>{}</th><th>off by</th>", escaped(second_explanation(diagnosis))) : "", rows);
}

std::string column_section(const ColumnResiduals& column, const std::string& unit, const std::string& second) {
    std::string plots;
    for (const std::string& plot : column.plots)
        plots += plot;
    return fmt::format(
        "<h3>{}</h3><p class=\"small\">One standard error of a reading is {:.3g} {}. Root mean square of "
        "{} residuals: {:.2f}{}; 1 is noise alone.</p><div class=\"plots\">{}</div>",
        escaped(column.name), column.sigma, unit, column.readings, column.before,
        second.empty() ? "" : fmt::format(" before, {:.2f} {}", column.after, escaped(second)), plots);
}

/// As a column's name has it in brackets.
std::string unit_in(const std::string& name) {
    const std::size_t at = name.rfind('[');
    return at == std::string::npos ? "" : name.substr(at + 1, name.size() - at - 2);
}

std::string residual_section(const Diagnosis& diagnosis) {
    const std::string second = second_explanation(diagnosis);
    std::string sections, left_out;
    for (const ColumnResiduals& column : residuals_by_column(diagnosis))
        if (column.plots.empty())
            left_out += (left_out.empty() ? "" : ", ") + escaped(column.name);
        else
            sections += column_section(column, unit_in(column.name), second);
    if (sections.empty())
        return "";
    if (!left_out.empty())
        sections += fmt::format("<p class=\"small\">Not drawn, for they lie nearest to noise: {}; residuals.csv has "
                                "them.</p>",
                                left_out);
    return "<h2>What the scene leaves unexplained</h2><p>Residual = measured less simulated, in standard errors of a "
           "reading; 95 % of pure noise lies in the grey band. Colours are conditions; lone outliers are not "
           "drawn.</p>" +
           sections;
}

} // namespace

std::string record_section(const Diagnosis& diagnosis) {
    const std::string measured = measured_records(diagnosis) + measured_numbers(diagnosis);
    return (measured.empty() ? "" : "<h2>What was measured, and what the scene gives</h2>" + measured) +
           residual_section(diagnosis);
}

std::string scatter_table(const Diagnosis& diagnosis) {
    struct Sums {
        std::string name, measure;
        double stated = 0, used = 0, records = 0;
    };
    std::vector<Sums> columns;
    for (const Curve& curve : diagnosis.curves) {
        const std::string name = column_name(curve);
        auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Sums& one) { return one.name == name && one.measure == curve.measure; });
        if (found == columns.end())
            found = columns.insert(columns.end(), {.name = name, .measure = curve.measure});
        found->stated += curve.stated;
        found->used += curve.sigma;
        ++found->records;
    }
    std::string rows;
    for (const Sums& one : columns) {
        const auto noise = diagnosis.noise.of.find(one.measure);
        rows += fmt::format("<tr><td>{}</td><td>{}</td>{}{}{}</tr>", escaped(one.name), escaped(one.measure),
                            cell(one.stated > 0 ? fmt::format("{:.3g}", one.stated / one.records) : "no"),
                            cell(fmt::format("{:.3g}", one.used / one.records)),
                            cell(noise == diagnosis.noise.of.end()
                                     ? ""
                                     : with_minus(fmt::format("{:.2f}", noise->second.correlation))));
    }
    if (rows.empty())
        return "";
    return "<table><tr><th>column</th><th>shows</th><th>scatter stated</th><th>scatter found</th><th>neighbours "
           "correlate by</th></tr>" +
           rows + "</table>";
}

} // namespace tumble::report
