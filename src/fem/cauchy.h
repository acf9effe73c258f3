#pragma once

#include "fem/brick.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

/// The stress vector on a plane, thesis (7.2) to (7.5).
namespace tumble::fem {

/// The plane's unit vectors: outward normal, along the contour (to the right of who looks at the plane from outside:
/// anticlockwise about the axis, and clockwise in a bore), along the axis. The thesis prints (7.3) to (7.5) with sums
/// of points and unit lengths; meant are these.
struct Directions {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
    Eigen::Vector3d contour = Eigen::Vector3d::UnitY();
    Eigen::Vector3d along = Eigen::Vector3d::UnitZ();
};

/// For a plane that is not across the axis; normal, contour and along are right-handed.
inline Directions directions_of(const Eigen::Vector3d& normal, const Eigen::Vector3d& axis) {
    const Eigen::Vector3d contour = axis.cross(normal).normalized();
    return {normal, contour, normal.cross(contour)};
}

/// T = sigma n, Pa (7.2).
inline Eigen::Vector3d stress_vector(const Stress& s, const Eigen::Vector3d& normal) {
    Eigen::Matrix3d tensor;
    tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return tensor * normal;
}

/// Its components along the normal (below 0: compression), the contour and the axis, Pa.
inline Eigen::Vector3d components(const Stress& stress, const Directions& at) {
    const Eigen::Vector3d vector = stress_vector(stress, at.normal);
    return {vector.dot(at.normal), vector.dot(at.contour), vector.dot(at.along)};
}

/// Pa.
inline double von_mises(const Stress& s) {
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

} // namespace tumble::fem
