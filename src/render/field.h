#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace tumble::render {

/// A surface whose points have a value each; between them it is linear over the triangles.
struct Field {
    std::vector<Eigen::Vector3d> points; // m, in the world
    std::vector<std::array<int, 3>> triangles;
    std::vector<double> values;            // a point each
    std::vector<std::array<int, 2>> lines; // drawn over it: edges of elements, outlines
    std::string label;                     // of the values
    std::string unit;                      // SI
    bool has_sign = false;                 // zero is the middle of the scale
};

} // namespace tumble::render
