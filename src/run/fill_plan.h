#pragma once

#include "scene/scene.h"
#include "sim3d/solver.h"

#include <cstdint>
#include <vector>

namespace tumble::run {

/// Bodies that each fill asks for, by count or by mass over the body's mass (rounded to the nearest).
std::vector<std::int64_t> bodies_wanted(const scene::Scene& scene, const std::vector<sim3d::BodyShape>& shapes);

/// Their sum.
std::int64_t all_bodies_wanted(const scene::Scene& scene, const std::vector<sim3d::BodyShape>& shapes);

} // namespace tumble::run
