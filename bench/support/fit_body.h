#pragma once

#include "sim3d/solver.h"
#include "support/sphere_file.h"

#include <array>
#include <span>

namespace tumble::bench {

struct FittedBody {
    sim3d::BodyState state;
    double miss = 0; // m, the farthest that a sphere lies from where the fit puts it
};

/// Pose and motion of a rigid body from its spheres, one for one with shape.spheres: rotation by Kabsch 1976 (singular
/// values of the covariance), velocities by least squares. Positions may be wrapped in x, whose period is `period` (m);
/// the body's centre is wrapped back into [lo, lo + period).
FittedBody fit_body(const sim3d::BodyShape& shape, std::span<const WrittenSphere> spheres, double lo, double period);

/// Bodies of shape 0 from a dump of as many consecutive spheres each. Ends the program when the count is no multiple or
/// a sphere lies farther than `tolerance` (m) from its place.
std::vector<sim3d::BodyState> fit_bodies(const sim3d::World& world, const std::vector<WrittenSphere>& spheres,
                                         double lo, double period, double tolerance);

} // namespace tumble::bench
