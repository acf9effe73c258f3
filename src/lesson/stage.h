#pragma once

#include "base/problem.h"
#include "lesson/walk.h"
#include "scene/scene.h"
#include "sim2d/solver.h"
#include "sim3d/solver.h"

#include <vector>

/// Small worlds for lessons: one material for everything, no gravity unless asked for, as much room as needed.
namespace tumble::lesson {

/// Discs 1 m deep under the linear law.
scene::Scene plane_stage(const contact::PairProperties& pair, double time_step);

/// Spheres under the law of Hertz and Mindlin.
scene::Scene space_stage(const contact::Material& material, const contact::PairProperties& pair, double time_step);

/// Adds a template and returns its index.
int add_body(scene::Scene& scene, const std::vector<scene::Sphere>& parts);
/// One disc or sphere; with a mass given (kg) density does not count.
int add_round(scene::Scene& scene, double radius);
int add_round(scene::Scene& scene, double radius, double mass);

scene::Wall& add_wall(scene::Scene& scene, const scene::Outline& outline);
scene::Wall& add_wall(scene::Scene& scene, const scene::WallShape& shape);

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

/// Spring of k_n (N/m), k_s over k_n, restitution, friction.
contact::PairProperties linear_pair(double stiffness, double ratio, double restitution, double friction);

} // namespace tumble::lesson
