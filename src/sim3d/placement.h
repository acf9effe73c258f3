#pragma once

#include "sim3d/world.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tumble::sim3d {

/// Where a body would stand.
struct Placement {
    int shape = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();     // m
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); // principal frame to world
};

Placement placement_of(const World& world, int slot);

Eigen::Vector3d bounding_centre(const World& world, const Placement& body);

/// What a kernel needs to look for near spheres of two bodies; the second is seen `shift` (m) away from its place.
SphereScan scan_between(const World& world, const Placement& a, const Placement& b, const Eigen::Vector3d& shift);

/// Runs the scan with scratch memory of this thread; candidates (a << 16 | b) stay valid until the next call.
int run_scan(const World& world, SphereScan& scan, double& smallest_gap, const std::uint32_t*& found);

/// Whether any spheres of the two overlap.
bool overlap(const World& world, const Placement& a, const Placement& b, const Eigen::Vector3d& shift);

/// The first wall, as they stand now, that a sphere of the body reaches into.
const WallState* wall_met(const World& world, const Placement& body);

} // namespace tumble::sim3d
