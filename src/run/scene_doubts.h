#pragma once

#include "run/simulation.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace tumble::run {

/// What can run but is hardly meant: units that slipped by powers of ten, bodies that never come. One text each: the
/// place in the scene, the doubt, and on the next line what to do.
std::vector<std::string> scene_doubts(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies);

/// The same of a wall that is far larger than the domain, as a mesh in millimetres read as metres is.
std::optional<std::string> doubt_of_size(const scene::Scene& scene, const scene::Wall& wall);

} // namespace tumble::run
