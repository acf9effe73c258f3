#pragma once

#include "base/problem.h"
#include "scene/scene.h"

/// Measures are words to a scene; here they are held against those there are. Problems have the key, but no place yet.
namespace tumble::run {

/// Those of [observe], and the one of the plot: it shows a single measure, so that a group's name is refused too.
Problems check_measures(const scene::Scene& scene);
Problems check_plot(const scene::Render& settings);

} // namespace tumble::run
