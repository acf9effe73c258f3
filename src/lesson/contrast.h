#pragma once

#include "lesson/stage.h"

#include <array>
#include <string>
#include <vector>

/// The experiments of the lesson on soft and hard contacts: each takes a stage (plane_stage, with what Box2D is told)
/// and goes by its solver. All bodies have the same mass and are made of discs of one radius.
namespace tumble::lesson::contrast {

constexpr double g = 9.81;              // m/s2
constexpr double radius = 0.01;         // m
constexpr double mass = 0.01;           // kg, whatever a body is made of
constexpr double steps_a_contact = 200; // of the soft stage
constexpr double hard_step = 1e-3;      // s
constexpr scene::Box2dSettings box2d{
    .time_step = hard_step, .velocity_iterations = 20, .position_iterations = 8, .rebound_above = 0};

/// The same under Box2D.
scene::Scene hard(scene::Scene scene);

/// A row of discs that touch.
std::vector<scene::Sphere> raft(int discs);

/// What an impact on a wall looks like from outside: the force that the body's change of velocity tells of.
struct Push {
    std::vector<double> time, force;                                // s, N
    double deepest = 0, strongest = 0, lasted = 0, restitution = 0; // m, N, s, -
};

/// The raft lands flat on a floor at `speed`, without gravity.
Result<Push> strike(scene::Scene scene, const std::vector<scene::Sphere>& parts, double speed);

/// Speeds of a striker and two discs that lie in a row with a gap (m), afterwards, over the striker's before.
Result<std::array<double, 3>> cradle(scene::Scene scene, double speed, double gap);

/// How far a block that lies on a floor slides from `speed` on, m.
Result<double> slides(scene::Scene scene, double mu, double speed);

constexpr int stacked = 10;

/// How far the top of a column of discs at rest has sunk, m.
Result<double> sunk(scene::Scene scene);

constexpr double poured_for = 0.9; // s

/// Discs that fall into a box.
scene::Scene pour(scene::Scene scene);

struct Poured {
    Curve energy; // mJ over s
    std::int64_t steps = 0;
    double passes = 0; // over contacts, in all
    double height = 0; // m, of the centre of mass at the end
};

/// `passes_a_step` over all contacts are what the solver needs.
Result<Poured> watch_pour(const scene::Scene& scene, const std::string& label, double passes_a_step);

} // namespace tumble::lesson::contrast
