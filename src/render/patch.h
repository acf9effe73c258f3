#pragma once

#include <Eigen/Core>
#include <array>

namespace tumble::render {

/// A flat convex piece of a drawing, pixels from the picture's left and top. A triangle has its last corner twice.
struct Patch {
    std::array<Eigen::Vector2d, 4> corners;
    Eigen::Vector3d color = Eigen::Vector3d::Zero(); // sRGB 0 to 1
    double opacity = 1;
};

} // namespace tumble::render
