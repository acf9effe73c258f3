#include "report/residual_plots.h"

#include "diagnose/measure_units.h"
#include "observe/measures.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tumble::report {

using namespace diagnose;

namespace {

const std::string over_time = "time [s]";

struct Looks {
    std::vector<std::string> conditions;
    bool named = false; // in a legend, each once

    /// For the first trace of a condition, before its index is asked for.
    [[nodiscard]] std::string label(const std::string& condition) const {
        const bool is_new = std::find(conditions.begin(), conditions.end(), condition) == conditions.end();
        return named && is_new ? condition : "";
    }

    std::size_t index(const std::string& condition) {
        for (std::size_t k = 0; k < conditions.size(); ++k)
            if (conditions[k] == condition)
                return k;
        conditions.push_back(condition);
        return conditions.size() - 1;
    }
};

bool has_extension(const Diagnosis& diagnosis) {
    return std::any_of(diagnosis.curves.begin(), diagnosis.curves.end(),
                       [](const Curve& curve) { return !curve.extended.empty(); });
}

Trace residual_trace(const Curve& curve, const std::vector<double>& model, const std::vector<double>& x, Looks& looks) {
    Trace trace{
        .label = looks.label(curve.condition), .x = x, .y = {}, .color = color_of(looks.index(curve.condition))};
    for (std::size_t k = 0; k < x.size(); ++k)
        trace.y.push_back(curve.left_out[k] ? std::nan("") : (curve.measured[k] - model[k]) / curve.sigma);
    return trace;
}

std::vector<double> rates(const Curve& curve) {
    std::vector<double> rate(curve.time.size(), std::nan(""));
    for (std::size_t k = 1; k + 1 < curve.time.size(); ++k)
        rate[k] = (curve.baseline[k + 1] - curve.baseline[k - 1]) / (curve.time[k + 1] - curve.time[k - 1]);
    return rate;
}

/// Residuals in standard errors, of all records that show the same measure as the first.
Plot residuals(const Diagnosis& diagnosis, const std::string& title, const std::string& against, bool extended,
               bool with_legend = false) {
    Plot plot{.title = title,
              .x_label = against,
              .y_label = "residual [standard errors]",
              .traces = {},
              .levels = {},
              .band = std::array{-2.0, 2.0},
              .y_range = {}};
    Looks looks{.conditions = {}, .named = with_legend};
    for (const Curve& curve : diagnosis.curves) {
        if (curve.head != diagnosis.curves[0].head)
            continue;
        const std::vector<double>& model = extended && !curve.extended.empty() ? curve.extended : curve.baseline;
        const std::vector<double> x = against == over_time           ? curve.time
                                      : against.starts_with("speed") ? rates(curve)
                                                                     : curve.baseline;
        plot.traces.push_back(residual_trace(curve, model, x, looks));
    }
    plot.levels.push_back({0, "", false});
    return plot;
}

double largest_residual(const Diagnosis& diagnosis) {
    double most = 4;
    for (const Curve& curve : diagnosis.curves)
        for (std::size_t k = 0; k < curve.time.size(); ++k)
            if (!curve.left_out[k])
                most = std::max(most, std::abs(curve.measured[k] - curve.baseline[k]) / curve.sigma);
    return most;
}

} // namespace

std::string bare_head(const Curve& curve) {
    for (const Unit& unit : units_for(curve.unit))
        if (!unit.name.empty() && curve.head.ends_with("_" + unit.name))
            return curve.head.substr(0, curve.head.size() - unit.name.size() - 1);
    return curve.head;
}

std::string second_explanation(const Diagnosis& diagnosis) {
    const auto& best = diagnosis.decision.best;
    return best && diagnosis.decision.outcome == Outcome::none_known
               ? diagnosis.causes[static_cast<std::size_t>(best->causes[0])].id
               : "the extended scene";
}

std::vector<std::string> residual_plots(const Diagnosis& diagnosis) {
    const std::string unit = diagnosis.curves.empty() ? "" : observe::spelled_unit(diagnosis.curves[0].unit);
    std::vector<std::string> plots{
        svg_of(residuals(diagnosis, "against time", over_time, false, true)),
        svg_of(residuals(diagnosis, "against speed", fmt::format("speed [{}/s]", unit), false)),
        svg_of(residuals(diagnosis, "against the reading", fmt::format("reading [{}]", unit), false))};
    if (has_extension(diagnosis)) {
        Plot after = residuals(diagnosis, "with " + second_explanation(diagnosis) + ", against time", over_time, true);
        const double most = largest_residual(diagnosis) * 1.05;
        after.y_range = std::array{-most, most};
        plots.push_back(svg_of(after));
    }
    return plots;
}

} // namespace tumble::report
