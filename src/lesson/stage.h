#pragma once

#include "base/problem.h"
#include "lesson/walk.h"
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

/// Lets a fill put one body of that template there at the start.
void put(scene::Scene& scene, int body, const Eigen::Vector2d& position, const Eigen::Vector2d& velocity);

/// That time or a little more, with one digit: so often a film takes its picture.
double one_digit(double time);

/// The scene's run from its start, a frame every `every` s, until the solver stops it or `until` (s). Problems: those
/// of the solver's build_world.
Result<Reel> film(const scene::Scene& scene, const std::string& label, double until, double every);

} // namespace tumble::lesson
