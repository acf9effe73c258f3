#pragma once

#include "base/books.h"
#include "base/problem.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What bodies, walls and fills are in the plane, whichever solver moves them.
namespace tumble::discs {

struct Disc {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(); // m, from the body's centre of mass
    double radius = 0;                                // m
};

/// A template as solvers use it: centred on its centre of mass, turned as written.
struct BodyShape {
    std::string name;
    double mass = 0;                                          // kg
    double area = 0;                                          // m2, of the union
    double inertia = 0;                                       // kg m2
    std::vector<Disc> discs;                                  // all of them, also wholly covered ones
    double bounding_radius = 0;                               // m, about the centre of mass
    Eigen::Vector2d written_centre = Eigen::Vector2d::Zero(); // m, centre of mass in the template's frame
};

struct BodyState {
    std::int64_t id = 0; // constant over the run, in order of insertion
    int shape = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero(); // m, centre of mass
    double angle = 0;                                   // rad, counter-clockwise, whole turns included
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero(); // m/s, at the same instant as the position
    double angular_velocity = 0;                        // rad/s, counter-clockwise
};

/// Why the first of the bodies that cannot be put into the scene's world cannot: a shape index that does not exist, a
/// position outside the domain, a number that is not finite.
std::optional<Problem> refusal_of(const std::vector<BodyState>& bodies, const scene::Scene& scene);

/// Kinetic and potential, J; `gravity` in m/s2.
double energy_of(const BodyState& body, const BodyShape& shape, const Eigen::Vector3d& gravity);

/// Adds the bodies' energies to the books and finds the fastest.
void book_motion(const std::vector<BodyState>& bodies, const std::vector<BodyShape>& shapes,
                 const Eigen::Vector3d& gravity, Books& books);

} // namespace tumble::discs
