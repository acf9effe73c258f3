#include "run/series_plot.h"

#include "base/text.h"
#include "observe/frame_file.h"
#include "observe/measures.h"
#include "render/ticks.h"
#include "run/replay.h"
#include "run/run_folder.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <utility>

namespace tumble::run {

namespace {

namespace fs = std::filesystem;

constexpr double alike = 10; // times as large, of two curves that one panel can show

/// The rows of one run in the stretch of time.
struct RunSeries {
    std::string label, title;
    observe::Series series;
};

/// How a column is called.
struct Named {
    std::string head, label, unit; // the unit as people write it
};

Named called(const std::string& head) {
    for (const observe::Measure& measure : observe::all_measures())
        if (measure.column() == head)
            return {head, observe::spelled_name(measure.name), observe::spelled_unit(measure.unit)};
    const std::string unit = observe::unit_in(head);
    std::string name = unit.empty() ? head : head.substr(0, head.size() - unit.size() - 1);
    if (name.starts_with("tracer:"))
        name.erase(0, std::string("tracer:").size());
    return {head, observe::spelled_name(name), observe::spelled_unit(unit)};
}

/// What several measures of one unit are called together.
std::string together(const std::string& unit) {
    static const std::map<std::string, std::string> words{{"J", "energy"},     {"m", "length"},
                                                          {"m/s", "velocity"}, {"m/s2", "acceleration"},
                                                          {"deg", "angle"},    {"rad/s", "angular velocity"},
                                                          {"s", "time"},       {"", "number"}};
    const auto found = words.find(unit);
    return found == words.end() ? "" : found->second;
}

Result<RunSeries> read_run(const fs::path& root, const SeriesPlotOptions& options) {
    const Result<RunFolder> folder = find_run(root);
    if (!folder)
        return folder.problems();
    if (std::error_code ignored; !fs::exists(folder->series(), ignored) && holds_stresses(root))
        return Problem{.file = root.string(),
                       .what = "holds what `tumble stress` recorded, and no series of measures",
                       .fix = fmt::format("its numbers over time stand in bulk.csv, cases.csv and slices.csv there; "
                                          "`tumble stress {} --pictures` draws the stresses, and `tumble run` makes a "
                                          "series",
                                          root.string())};
    Result<observe::Series> whole = observe::read_series(folder->series());
    if (!whole)
        return whole.problems();
    RunSeries run{folder_name(root), {}, {whole->columns, {}}};
    if (const auto layout = observe::read_layout(observe::layout_path(folder->frames())))
        run.title = (*layout)->title;
    const std::vector<double>* times = whole->find("time_s");
    if (!times)
        return Problem{.file = folder->series().string(),
                       .what = "has no column time_s",
                       .fix = "plot a run that `tumble run` made"};
    for (const std::vector<double>& column : whole->values) {
        std::vector<double>& kept = run.series.values.emplace_back();
        for (std::size_t row = 0; row < whole->rows(); ++row)
            if ((*times)[row] >= options.from && (*times)[row] <= options.to)
                kept.push_back(column[row]);
    }
    if (run.series.rows() == 0)
        return Problem{.file = folder->series().string(),
                       .what = "has no row in the time asked for",
                       .fix = times->empty()
                                  ? "run the scene again"
                                  : fmt::format("its rows go from {:.6g} to {:.6g} s", times->front(), times->back())};
    return run;
}

Result<std::vector<RunSeries>> read_runs(const std::vector<fs::path>& roots, const SeriesPlotOptions& options) {
    std::vector<RunSeries> runs;
    Problems problems;
    for (const fs::path& root : roots) {
        auto run = read_run(root, options);
        append(problems, run.problems());
        if (run)
            runs.push_back(std::move(*run));
    }
    if (problems.empty() && runs.empty())
        problems.push_back({.what = "no run is given", .fix = "give the folder that `tumble run` made"});
    if (!problems.empty())
        return problems;
    return runs;
}

/// The largest size of a column in all runs; nothing where it has no number.
std::optional<double> largest_size(const std::vector<RunSeries>& runs, const std::string& head) {
    std::optional<double> size;
    for (const RunSeries& run : runs)
        if (const std::vector<double>* values = run.series.find(head))
            for (const double value : *values)
                if (std::isfinite(value))
                    size = std::max(size.value_or(0), std::abs(value));
    return size;
}

/// Whether there never were two bodies, which alone can circulate or make a slope.
bool is_of_one_body(const observe::Series& series) {
    const std::vector<double>* bodies = series.find("bodies");
    return bodies && std::none_of(bodies->begin(), bodies->end(), [](double count) { return count >= 2; });
}

std::vector<std::string> usual_columns(const observe::Series& series) {
    std::vector<std::string> heads;
    for (const std::string& name : main_measures())
        if (const auto chosen = choose_columns(series, name, ""))
            heads.insert(heads.end(), chosen->begin(), chosen->end());
    const auto height = std::find_if(series.columns.begin(), series.columns.end(), [](const std::string& head) {
        return head.starts_with("tracer:") && head.ends_with("_y_m");
    });
    if (height != series.columns.end())
        heads.push_back(*height);
    const bool alone = is_of_one_body(series);
    std::erase_if(heads, [&](const std::string& head) {
        if (alone && (head.starts_with("circulation") || head.starts_with("surface_slope")))
            return true;
        const std::vector<double>& values = *series.find(head);
        return std::none_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    });
    return heads.empty() ? std::vector<std::string>(series.columns.begin() + 1, series.columns.end()) : heads;
}

Result<std::vector<std::string>> wanted_columns(const RunSeries& run, const std::string& root,
                                                const std::vector<std::string>& words) {
    if (words.empty())
        return usual_columns(run.series);
    std::vector<std::string> heads;
    Problems problems;
    for (const std::string& word : words) {
        const auto chosen = choose_columns(run.series, word, root);
        append(problems, chosen.problems());
        for (const std::string& head : chosen ? *chosen : std::vector<std::string>{})
            if (std::find(heads.begin(), heads.end(), head) == heads.end())
                heads.push_back(head);
    }
    if (!problems.empty())
        return problems;
    return heads;
}

/// Measures that share a panel.
struct Group {
    std::string unit;
    double least = 0, most = 0; // sizes; zeros fit everywhere
    std::vector<Named> measures{};

    [[nodiscard]] bool several() const { return measures.size() > 1; }
    [[nodiscard]] bool takes(const Named& measure, double size) const {
        const double low = least > 0 && size > 0 ? std::min(least, size) : std::max(least, size);
        return measure.unit == unit && std::max(most, size) <= alike * low;
    }
    void add(const Named& measure, double size) {
        least = least > 0 && size > 0 ? std::min(least, size) : std::max(least, size);
        most = std::max(most, size);
        measures.push_back(measure);
    }
};

std::vector<Group> grouped(const std::vector<RunSeries>& runs, const std::vector<std::string>& heads,
                           std::vector<std::string>& warnings) {
    std::vector<Group> groups;
    for (const std::string& head : heads) {
        const std::optional<double> size = largest_size(runs, head);
        if (!size) {
            warnings.push_back(fmt::format("{} has no number in this time", head));
            continue;
        }
        const Named measure = called(head);
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const Group& one) { return one.takes(measure, *size); });
        if (group == groups.end())
            group = groups.insert(groups.end(), Group{.unit = measure.unit});
        group->add(measure, *size);
    }
    return groups;
}

void scale(std::vector<double>& values, double factor) {
    for (double& value : values)
        value *= factor;
}

/// `by_dashes`: some panel has several measures, which then have the colours, and the runs have dashes.
sheet::Panel panel_of(const std::vector<RunSeries>& runs, const Group& group, double time_factor, bool by_dashes) {
    const bool several = group.several();
    const render::DisplayUnit unit = render::display_unit(group.unit, {-group.most, group.most});
    sheet::Panel panel;
    panel.y = {several ? together(group.unit) : group.measures.front().label, unit.unit};
    for (std::size_t m = 0; m < group.measures.size(); ++m)
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const std::vector<double>* values = runs[r].series.find(group.measures[m].head);
            if (!values)
                continue;
            const bool labelled = several && (panel.traces.empty() || panel.traces.back().ink.color != m);
            const std::size_t color = by_dashes || runs.size() == 1 ? m : r;
            sheet::Trace trace{{labelled ? group.measures[m].label : "", color, by_dashes ? r : color / sheet::colors},
                               *runs[r].series.find("time_s"),
                               *values};
            scale(trace.x, time_factor);
            scale(trace.y, unit.factor);
            panel.traces.push_back(std::move(trace));
        }
    return panel;
}

std::string common_title(const std::vector<RunSeries>& runs) {
    const bool same =
        std::all_of(runs.begin(), runs.end(), [&](const RunSeries& run) { return run.title == runs.front().title; });
    return same ? runs.front().title : "";
}

/// Labels for the runs, all different.
std::optional<Problem> name_runs(std::vector<RunSeries>& runs, const std::vector<fs::path>& roots,
                                 const std::vector<std::string>& labels) {
    if (!labels.empty() && labels.size() != runs.size())
        return Problem{.what = fmt::format("{} labels are given for {} runs", labels.size(), runs.size()),
                       .fix = "give one for each, with commas between"};
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const auto same = [&](const fs::path& root) { return folder_name(root) == folder_name(roots[r]); };
        if (!labels.empty())
            runs[r].label = labels[r];
        else if (std::count_if(roots.begin(), roots.end(), same) > 1)
            runs[r].label = roots[r].string();
    }
    return std::nullopt;
}

std::vector<std::string> what_is_missing(const std::vector<RunSeries>& runs, const std::vector<fs::path>& roots,
                                         const std::vector<std::string>& heads) {
    std::vector<std::string> warnings;
    for (std::size_t r = 1; r < runs.size(); ++r)
        for (const std::string& head : heads)
            if (!runs[r].series.find(head))
                warnings.push_back(fmt::format("{}: its series has no {}", roots[r].string(), head));
    return warnings;
}

/// s
std::pair<double, double> stretch_of(const std::vector<RunSeries>& runs) {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const RunSeries& run : runs) {
        first = std::min(first, run.series.find("time_s")->front());
        last = std::max(last, run.series.find("time_s")->back());
    }
    return {first, last};
}

std::vector<sheet::Ink> legend_of(const std::vector<RunSeries>& runs, bool by_dashes) {
    std::vector<sheet::Ink> legend;
    for (std::size_t r = 0; r < runs.size() && runs.size() > 1; ++r)
        legend.push_back({runs[r].label, by_dashes ? std::optional<std::size_t>() : std::optional(r),
                          by_dashes ? r : r / sheet::colors});
    return legend;
}

/// Warnings where lines look alike.
std::vector<std::string> told_apart(const std::vector<Group>& groups, std::size_t runs, bool several) {
    std::size_t measures = 0;
    for (const Group& group : groups)
        measures = std::max(measures, group.measures.size());
    const bool by_dashes = several && runs > 1;
    std::vector<std::string> warnings;
    const auto warn = [&](std::size_t count, std::size_t most, const char* what, const char* by) {
        if (count > most)
            warnings.push_back(fmt::format("{} {} have only {} {} between them: some look alike; plot fewer at a time",
                                           count, what, most, by));
    };
    if (by_dashes) {
        warn(measures, sheet::colors, "measures in one plot", "colours");
        warn(runs, sheet::dash_patterns, "runs", "kinds of dashes");
    } else
        warn(std::max(measures, runs), sheet::colors * sheet::dash_patterns, "lines", "colours and dashes");
    return warnings;
}

} // namespace

const std::vector<std::string>& main_measures() {
    static const std::vector<std::string> names{"kinetic_energy", "circulation", "surface_slope", "lost_energy"};
    return names;
}

Result<std::vector<std::string>> choose_columns(const observe::Series& series, const std::string& word,
                                                const std::string& run) {
    const auto has = [&](const std::string& head) {
        return std::find(series.columns.begin() + 1, series.columns.end(), head) != series.columns.end();
    };
    std::vector<std::string> chosen;
    std::vector<std::string> names; // by which columns can be asked for
    for (auto head = series.columns.begin() + 1; head < series.columns.end(); ++head) {
        const std::string unit = observe::unit_in(*head);
        names.push_back(unit.empty() ? *head : head->substr(0, head->size() - unit.size() - 1));
        if (word == *head || word == names.back() || (word.starts_with("tracer:") && head->starts_with(word + "_")))
            chosen.push_back(*head);
    }
    const auto measures = observe::choose_measures({word});
    if (chosen.empty() && measures)
        for (const observe::Measure& measure : *measures)
            if (has(measure.column()))
                chosen.push_back(measure.column());
    if (!chosen.empty())
        return chosen;
    std::string fix = did_you_mean(word, names);
    if (measures)
        fix = "run the scene again with it in observe.measures;";
    return Problem{.file = run,
                   .what = fmt::format("the series of this run has no '{}'", excerpt(word)),
                   .fix = fmt::format("{}{}it has {}", fix, fix.empty() ? "" : " ", fmt::join(names, ", "))};
}

Result<SeriesPlot> plot_series(const std::vector<fs::path>& roots, const SeriesPlotOptions& options) {
    auto runs = read_runs(roots, options);
    if (!runs)
        return runs.problems();
    if (const auto problem = name_runs(*runs, roots, options.labels))
        return *problem;
    const auto heads = wanted_columns(runs->front(), roots.front().string(), options.measures);
    if (!heads)
        return heads.problems();
    SeriesPlot plot;
    plot.warnings = what_is_missing(*runs, roots, *heads);
    for (const fs::path& root : roots)
        for (const std::string& sentence : how_it_ended(*find_run(root)))
            plot.warnings.push_back(roots.size() > 1 ? root.string() + ": " + sentence : sentence);
    const std::vector<Group> groups = grouped(*runs, *heads, plot.warnings);
    if (groups.empty())
        return Problem{.file = roots.front().string(),
                       .what = "there is nothing to plot: no number of these measures in this time",
                       .fix = "ask for others with --measure, or for another --time"};
    const auto [first, last] = stretch_of(*runs);
    plot.first = first;
    plot.last = last;
    const bool several = std::any_of(groups.begin(), groups.end(), [](const Group& one) { return one.several(); });
    for (std::string& warning : told_apart(groups, runs->size(), several))
        plot.warnings.push_back(std::move(warning));
    const render::DisplayUnit time = render::display_unit("s", {first, last});
    plot.stack.title = common_title(*runs);
    plot.stack.x = {"time", time.unit};
    plot.stack.legend = legend_of(*runs, several);
    for (const Group& group : groups) {
        plot.stack.panels.push_back(panel_of(*runs, group, time.factor, several && runs->size() > 1));
        std::vector<std::string>& columns = plot.columns.emplace_back();
        for (const Named& measure : group.measures)
            columns.push_back(measure.head);
    }
    return plot;
}

} // namespace tumble::run
