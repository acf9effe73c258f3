#pragma once

#include "base/problem.h"
#include "scene/stage.h"
#include "sim2d/solver.h"
#include "sim3d/solver.h"

#include <vector>

/// Worlds of small scenes, with bodies exactly where a lesson wants them.
namespace tumble::lesson {

using scene::add_body;
using scene::add_round;
using scene::add_wall;
using scene::linear_pair;
using scene::plane_stage;
using scene::space_stage;

/// A world with these bodies in it. Problems: those of the solver.
Result<sim2d::WorldPtr> start(const scene::Scene& scene, const std::vector<sim2d::BodyState>& bodies);
Result<sim3d::WorldPtr> start(const scene::Scene& scene, const std::vector<sim3d::BodyState>& bodies);

} // namespace tumble::lesson
