#pragma once

#include <Eigen/Core>
#include <array>

/// The eight-node brick and its four-node facet: shape functions, corners in the order of CalculiX and Abaqus (C3D8):
/// the first four counter-clockwise seen from the second four, which stand above them.
namespace tumble::solid {

using Corners = Eigen::Matrix<double, 3, 8>; // m, one column a corner

/// Natural coordinates of the corners, each -1 or 1.
extern const Eigen::Matrix<double, 3, 8> corner_signs;

/// Where stresses and stiffnesses are sampled: the corners drawn in to 1/sqrt(3); each counts with weight 1.
Eigen::Vector3d gauss_point(int point);

/// Values at a natural point; they add up to 1.
Eigen::Matrix<double, 8, 1> shape_at(const Eigen::Vector3d& natural);

/// Derivatives by the three natural coordinates, one column a corner.
Eigen::Matrix<double, 3, 8> slopes_at(const Eigen::Vector3d& natural);

/// d(place)/d(natural): column j is the derivative by natural coordinate j.
Eigen::Matrix3d jacobian_at(const Corners& corners, const Eigen::Vector3d& natural);

/// Corners of the six faces, outward by the right-hand rule; numbered as CalculiX does, from 0.
constexpr std::array<std::array<int, 4>, 6> face_corners{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Values of a facet's four corners at its natural point (r, s); they add up to 1.
Eigen::Vector4d facet_shape_at(double r, double s);

} // namespace tumble::solid
