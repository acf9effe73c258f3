#pragma once

#include <Eigen/Core>
#include <array>

namespace tumble::fit {

struct Sphere {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // m, template frame as written
    double radius = 0;                                // m
};

using Triangle = std::array<Eigen::Vector3d, 3>; // m

/// An upright cone: its axis is y, its base lies at y = 0.
struct Cone {
    double diameter = 0; // m, of the base
    double height = 0;   // m
};

} // namespace tumble::fit
