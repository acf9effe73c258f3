#include "run/measure_names.h"

#include "base/text.h"
#include "observe/tracer.h"
#include "run/tracers.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::run {

namespace {

constexpr std::size_t names_told = 4;

/// The candidates that are spelled most like the word.
std::vector<std::string> names_close_by(const std::string& word, std::vector<std::string> candidates) {
    std::stable_sort(candidates.begin(), candidates.end(), [&](const std::string& a, const std::string& b) {
        return typing_distance(word, a) < typing_distance(word, b);
    });
    candidates.resize(std::min(candidates.size(), names_told));
    return candidates;
}

std::vector<observe::TracerColumn> traced_columns(const std::vector<std::string>& traced) {
    std::vector<observe::TracerColumn> all;
    for (const std::string& body : traced)
        for (observe::TracerColumn& column : observe::tracer_columns(body))
            all.push_back(std::move(column));
    return all;
}

Result<Plotted> find_traced(const std::string& name, const std::vector<std::string>& traced) {
    std::vector<std::string> names;
    for (const observe::TracerColumn& column : traced_columns(traced)) {
        if (name == column.name || name == column.column())
            return Plotted{name, observe::spelled_name(column.name.substr(column.name.find(':') + 1)),
                           observe::spelled_unit(column.unit), column.column()};
        names.push_back(column.name);
    }
    const std::string what = fmt::format("there is no column '{}' of a body that is traced", name);
    if (names.empty())
        return Problem{.what = what + ": observe.measures traces none",
                       .fix = "add \"tracer:BODY\" to observe.measures, with the name of a [body.NAME]"};
    return Problem{.what = what,
                   .fix = fmt::format("close by are {}; `tumble list measures SCENE` names all of them",
                                      fmt::join(names_close_by(name, std::move(names)), ", "))};
}

Result<Plotted> find_measure(const std::string& name) {
    const auto plotted = [&](const observe::Measure& measure) {
        return Plotted{name, observe::spelled_name(measure.name), observe::spelled_unit(measure.unit), measure.column(),
                       measure};
    };
    for (const observe::Measure& measure : observe::all_measures())
        if (measure.column() == name)
            return plotted(measure);
    const auto chosen = observe::choose_measures({name});
    if (!chosen)
        return chosen.problems();
    if (chosen->size() == 1)
        return plotted(chosen->front());
    std::vector<std::string> names;
    for (const observe::Measure& measure : *chosen)
        names.push_back(measure.name);
    return Problem{.what = fmt::format("'{}' names {} measures, and the small plot shows one", name, names.size()),
                   .fix = fmt::format("write one of {}", fmt::join(names, ", "))};
}

} // namespace

Problems check_measures(const scene::Scene& scene) {
    Problems problems = observe::choose_measures(without_tracers(scene.observe.measures)).problems();
    append(problems, check_tracers(scene));
    append(problems, find_plotted(scene.render, traced_bodies(scene.observe.measures)).problems());
    return problems;
}

Result<Plotted> find_plotted(const scene::Render& settings, const std::vector<std::string>& traced) {
    const std::string& name = settings.plot_measure;
    Result<Plotted> found = name.starts_with("tracer:") ? find_traced(name, traced) : find_measure(name);
    if (found)
        return found;
    Problems problems = found.problems();
    for (Problem& problem : problems)
        problem.key = "render.plot_measure";
    return problems;
}

} // namespace tumble::run
