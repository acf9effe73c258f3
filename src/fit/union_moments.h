#pragma once

#include "fit/shapes.h"

#include <Eigen/Core>
#include <vector>

namespace tumble::fit {

/// Volume, centre and second moments of a union of spheres, overlaps counted once.
struct UnionMoments {
    double volume = 0;                                // m3
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // m
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero(); // m5, integral of (x - centre)(x - centre)^T
    double error = 0; // -, estimated: the largest of the volume's and the moments' relative errors
    int slices = 0;   // how many planes were cut
};

/// Cuts the union into planes of constant y. In a plane the spheres are discs, and the moments of a union of discs are
/// exact sums over the arcs of its outline (Green's theorem); across planes by adaptive Gauss-Kronrod (7, 15) between
/// the heights where spheres begin and end, to `tolerance` (relative). One sphere: closed form.
UnionMoments union_moments(const std::vector<Sphere>& spheres, double tolerance = 1e-8);

} // namespace tumble::fit
