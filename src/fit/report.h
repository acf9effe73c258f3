#pragma once

#include "fit/shapes.h"
#include "fit/solid.h"

#include <string>
#include <vector>

namespace tumble::fit {

/// How well the union of some spheres stands for a solid. Moments of inertia are those of unit density, about each
/// one's own centre, along its own principal axes, ascending.
struct Report {
    double solid_volume = 0, union_volume = 0;                                                        // m3
    Eigen::Vector3d solid_centre = Eigen::Vector3d::Zero(), union_centre = Eigen::Vector3d::Zero();   // m
    Eigen::Vector3d solid_inertia = Eigen::Vector3d::Zero(), union_inertia = Eigen::Vector3d::Zero(); // m5
    double gap_mean = 0;   // m, mean distance of the union from points of the solid's surface, to either side
    double gap_max = 0;    // m, the farthest that the surface stands off the union
    double stands_out = 0; // m, the farthest that a sphere with its centre inside stands out of the solid; 0: none does
    double smallest = 0, largest = 0; // m, radii
};

Report compare(const Solid& solid, const std::vector<Sphere>& spheres);

/// All lengths times one factor, about the origin, so that the union has the volume (m3). Returns the factor.
double scale_to_volume(std::vector<Sphere>& spheres, double volume);

/// Radius (m) of the sphere of that volume (m3).
double equivalent_radius(double volume);

/// A clump file: the report as comments, each line of `made_by` as one before it, then the spheres, shortest digits
/// that read back to the same bits.
std::string clump_file(const std::vector<Sphere>& spheres, const Report& report,
                       const std::vector<std::string>& made_by);

/// What would bring the spheres nearer to the solid, a sentence each; none where they are near.
std::vector<std::string> advice(const Report& report);

/// The report in a few plain lines.
std::vector<std::string> sentences(const Report& report, std::size_t spheres);

} // namespace tumble::fit
