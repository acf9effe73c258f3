#include "report/residual_plots.h"

#include "diagnose/measure_units.h"
#include "observe/measures.h"
#include "report/spectrum_plot.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr std::size_t most_in_full = 3;      // columns against speed, reading, phase and frequency, too
constexpr std::size_t most_columns = 12;     // that are drawn
constexpr std::size_t most_colours = 7;      // conditions told apart
constexpr std::size_t longest_title = 44;    // letters that fit above a plot
constexpr double same_scale = 4;             // times what is left: before and after share a scale
const std::string colour_of_others = "#bbb"; // conditions beyond those

/// Records of one column: curves of one name and unit.
struct Column {
    std::vector<const Curve*> curves;
    std::vector<std::string> conditions; // of the measurement, those farthest off first where there are many
    double before = 0, after = 0;        // root mean square
};

double left_of(const Curve& curve, const std::vector<double>& model, std::size_t k) {
    return curve.left_out[k] ? std::nan("") : (curve.measured[k] - model[k]) / curve.sigma;
}

const std::vector<double>& after_of(const Curve& curve) {
    return curve.extended.empty() ? curve.baseline : curve.extended;
}

double rms_of(const std::vector<const Curve*>& curves, bool after) {
    double sum = 0, count = 0;
    for (const Curve* curve : curves)
        for (std::size_t k = 0; k < curve->time.size(); ++k)
            if (const double left = left_of(*curve, after ? after_of(*curve) : curve->baseline, k); !std::isnan(left)) {
                sum += left * left;
                ++count;
            }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

double largest_of(const Column& column, bool after) {
    double most = 0;
    for (const Curve* curve : column.curves)
        for (std::size_t k = 0; k < curve->time.size(); ++k)
            if (const double left = left_of(*curve, after ? after_of(*curve) : curve->baseline, k); !std::isnan(left))
                most = std::max(most, std::abs(left));
    return most;
}

/// In the order of the measurement; where there are more than colours those farthest off come first.
std::vector<std::string> conditions_of(const std::vector<const Curve*>& curves) {
    std::vector<std::string> names;
    for (const Curve* curve : curves)
        if (std::find(names.begin(), names.end(), curve->condition) == names.end())
            names.push_back(curve->condition);
    if (names.size() <= most_colours)
        return names;
    const auto off = [&](const std::string& name) {
        std::vector<const Curve*> own;
        std::copy_if(curves.begin(), curves.end(), std::back_inserter(own),
                     [&](const Curve* curve) { return curve->condition == name; });
        return rms_of(own, false);
    };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return off(a) > off(b); });
    return names;
}

std::vector<Column> columns_of(const Diagnosis& diagnosis) {
    std::vector<Column> columns;
    std::vector<std::string> names;
    for (const Curve& curve : diagnosis.curves) {
        if (is_number(curve))
            continue;
        const std::string name = column_name(curve);
        const auto known = std::find(names.begin(), names.end(), name);
        const auto index = static_cast<std::size_t>(known - names.begin());
        if (known == names.end()) {
            names.push_back(name);
            columns.emplace_back();
        }
        columns[index].curves.push_back(&curve);
    }
    for (Column& column : columns) {
        column.conditions = conditions_of(column.curves);
        column.before = rms_of(column.curves, false);
        column.after = rms_of(column.curves, true);
    }
    return columns;
}

/// Colour and word of a condition: the last colour stays for all others where there are too many.
std::array<std::string, 2> look_of(const Column& column, const std::string& condition) {
    const auto index = static_cast<std::size_t>(
        std::find(column.conditions.begin(), column.conditions.end(), condition) - column.conditions.begin());
    const std::size_t all = column.conditions.size();
    if (all <= most_colours || index + 1 < most_colours)
        return {color_of(index), condition};
    return {colour_of_others, fmt::format("{} others", all - (most_colours - 1))};
}

std::vector<double> rates(const Curve& curve) {
    std::vector<double> rate(curve.time.size(), std::nan(""));
    for (std::size_t k = 1; k + 1 < curve.time.size(); ++k)
        rate[k] = (curve.baseline[k + 1] - curve.baseline[k - 1]) / (curve.time[k + 1] - curve.time[k - 1]);
    return rate;
}

std::vector<double> phases(const Curve& curve) {
    std::vector<double> phase;
    for (const double time : curve.time) {
        const double periods = (time - curve.shaken_from) / curve.shaken;
        phase.push_back(360 * (periods - std::floor(periods)));
    }
    return phase;
}

using Abscissa = std::vector<double> (*)(const Curve&);

/// Residuals of a column, each condition named once where there is a legend.
Plot residuals(const Column& column, const std::string& title, const std::string& label, Abscissa abscissa, bool after,
               bool with_legend = false) {
    Plot plot{.title = title,
              .x_label = label,
              .y_label = "residual [standard errors]",
              .traces = {},
              .levels = {},
              .band = std::array{-2.0, 2.0},
              .y_range = {}};
    std::vector<std::string> named;
    for (const Curve* curve : column.curves) {
        const auto [colour, word] = look_of(column, curve->condition);
        const bool is_new = std::find(named.begin(), named.end(), word) == named.end();
        named.push_back(word);
        Trace trace{.label = with_legend && is_new ? word : "", .x = abscissa(*curve), .y = {}, .color = colour};
        for (std::size_t k = 0; k < curve->time.size(); ++k)
            trace.y.push_back(left_of(*curve, after ? after_of(*curve) : curve->baseline, k));
        plot.traces.push_back(std::move(trace));
    }
    std::stable_partition(plot.traces.begin(), plot.traces.end(), // the others lie below
                          [](const Trace& trace) { return trace.color == colour_of_others; });
    plot.levels.push_back({0, "", false});
    return plot;
}

void draw_over_time(const Diagnosis& diagnosis, const Column& column, std::vector<std::string>& plots) {
    const auto time = [](const Curve& curve) { return curve.time; };
    const std::string head = bare_head(*column.curves[0]), second = second_explanation(diagnosis);
    Plot before = residuals(column, head + ": residual against time", "time [s]", time, false, true);
    const double most = std::max(3.0, 1.05 * largest_of(column, false));
    const double rest = std::max(3.0, 1.05 * largest_of(column, true));
    before.y_range = std::array{-most, most};
    plots.push_back(svg_of(before));
    if (second.empty() || column.curves[0]->extended.empty())
        return;
    const bool finer = most > same_scale * rest;
    const std::string scale = finer ? ", finer scale" : "", title = head + ": " + second + scale;
    Plot after = residuals(column, title.size() > longest_title ? head + ": with both" + scale : title, "time [s]",
                           time, true, false);
    const double end = finer ? rest : std::max(most, rest);
    after.y_range = std::array{-end, end};
    plots.push_back(svg_of(after));
}

void draw_in_full(const Diagnosis& diagnosis, const Column& column, std::vector<std::string>& plots) {
    const Curve& first = *column.curves[0];
    const std::string unit = observe::spelled_unit(first.unit), head = bare_head(first);
    if (first.unit != "s") { // a clock's speed is 1, its reading is time
        const std::string rate = unit.find('/') == std::string::npos ? unit + "/s" : "(" + unit + ")/s";
        const char* word = first.unit == "m" ? "speed" : first.unit == "m_s" ? "acceleration" : "rate of change";
        plots.push_back(svg_of(residuals(column, fmt::format("{}: against {}", head, word),
                                         fmt::format("{} [{}]", word, rate), rates, false)));
        const auto reading = [](const Curve& curve) { return curve.baseline; };
        plots.push_back(svg_of(residuals(column, head + ": against the reading",
                                         fmt::format("{} as simulated [{}]", head, unit), reading, false)));
    }
    if (first.shaken > 0)
        plots.push_back(svg_of(
            residuals(column, head + ": against the shaking", "phase of the slowest vibration [deg]", phases, false)));
    for (std::string& spectrum : spectrum_plots(diagnosis, first.measure, head))
        plots.push_back(std::move(spectrum));
}

/// Numbers of the columns, those that the scene leaves farthest off first.
std::vector<std::size_t> farthest_first(const std::vector<Column>& columns) {
    std::vector<std::size_t> order(columns.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return columns[a].before > columns[b].before; });
    return order;
}

ColumnResiduals summed_up(const Column& column) {
    ColumnResiduals one{.name = column_name(*column.curves[0]),
                        .sigma = 0,
                        .before = column.before,
                        .after = column.after,
                        .readings = 0,
                        .plots = {}};
    for (const Curve* curve : column.curves) {
        one.sigma += curve->sigma / static_cast<double>(column.curves.size());
        one.readings += static_cast<int>(std::count(curve->left_out.begin(), curve->left_out.end(), false));
    }
    return one;
}

} // namespace

std::string bare_head(const Curve& curve) {
    for (const Unit& unit : units_for(curve.unit))
        if (!unit.name.empty() && curve.head.ends_with("_" + unit.name))
            return curve.head.substr(0, curve.head.size() - unit.name.size() - 1);
    return curve.head;
}

std::string column_name(const Curve& curve) {
    return curve.unit.empty() ? curve.head
                              : fmt::format("{} [{}]", bare_head(curve), observe::spelled_unit(curve.unit));
}

std::string second_explanation(const Diagnosis& diagnosis) {
    const auto& best = diagnosis.decision.best;
    if (!best || best->causes.empty())
        return "";
    std::string words;
    for (const int k : best->causes)
        words += (words.empty() ? "with " : " and ") + diagnosis.causes[static_cast<std::size_t>(k)].id;
    return words;
}

std::vector<ColumnResiduals> residuals_by_column(const Diagnosis& diagnosis) {
    const std::vector<Column> columns = columns_of(diagnosis);
    const std::vector<std::size_t> order = farthest_first(columns);
    std::vector<ColumnResiduals> all;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const auto rank = static_cast<std::size_t>(std::find(order.begin(), order.end(), k) - order.begin());
        ColumnResiduals one = summed_up(columns[k]);
        if (rank < most_columns)
            draw_over_time(diagnosis, columns[k], one.plots);
        if (rank < most_in_full)
            draw_in_full(diagnosis, columns[k], one.plots);
        all.push_back(std::move(one));
    }
    return all;
}

std::vector<std::string> residual_plots(const Diagnosis& diagnosis) {
    std::vector<std::string> plots;
    for (const ColumnResiduals& column : residuals_by_column(diagnosis))
        plots.insert(plots.end(), column.plots.begin(), column.plots.end());
    return plots;
}

} // namespace tumble::report
