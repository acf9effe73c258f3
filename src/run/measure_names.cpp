#include "run/measure_names.h"

#include "observe/measures.h"
#include "run/tracers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::run {

Problems check_measures(const scene::Scene& scene) {
    Problems problems = observe::choose_measures(without_tracers(scene.observe.measures)).problems();
    for (const Problem& problem : check_tracers(scene))
        problems.push_back(problem);
    const Problems plot = check_plot(scene.render);
    problems.insert(problems.end(), plot.begin(), plot.end());
    return problems;
}

Problems check_plot(const scene::Render& settings) {
    const auto chosen = observe::choose_measures({settings.plot_measure});
    Problems problems = chosen.problems();
    if (chosen && chosen->size() != 1) {
        std::vector<std::string> names;
        for (const observe::Measure& measure : *chosen)
            names.push_back(measure.name);
        problems = {{.what = fmt::format("'{}' names {} measures, and the small plot shows one", settings.plot_measure,
                                         names.size()),
                     .fix = fmt::format("write one of {}", fmt::join(names, ", "))}};
    }
    for (Problem& problem : problems)
        problem.key = "render.plot_measure";
    return problems;
}

} // namespace tumble::run
