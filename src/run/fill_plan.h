#pragma once

#include "run/simulation.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace tumble::run {

/// Bodies that each fill asks for, by count or by mass over the body's mass (rounded to the nearest).
std::vector<std::int64_t> bodies_wanted(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies);

/// Their sum.
std::int64_t all_bodies_wanted(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies);

} // namespace tumble::run
