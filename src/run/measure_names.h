#pragma once

#include "base/problem.h"
#include "observe/measures.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

/// Measures are words to a scene; here they are held against those there are. Problems have the key, but no place yet.
namespace tumble::run {

/// Those of [observe], and the one of the plot: it shows a single number, so that a group's name is refused too.
Problems check_measures(const scene::Scene& scene);

/// What the small plot shows.
struct Plotted {
    std::string name;                          // as the scene has it
    std::string label;                         // as people read it
    std::string unit;                          // the same
    std::string column;                        // its head in series.csv
    std::optional<observe::Measure> measure{}; // nothing: a column of a tracer
};

/// By the name of a measure, or of a column of the bodies that are traced; units may follow as they do in series.csv.
Result<Plotted> find_plotted(const scene::Render& settings, const std::vector<std::string>& traced);

} // namespace tumble::run
