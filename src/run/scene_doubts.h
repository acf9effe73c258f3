#pragma once

#include "run/simulation.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace tumble::run {

/// What can run but is hardly meant: units that slipped by powers of ten, bodies that never come. One text each: the
/// place in the scene, the doubt, and on the next line what to do.
std::vector<std::string> scene_doubts(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies);

} // namespace tumble::run
