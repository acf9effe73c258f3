#pragma once

#include "solid/facet_load.h"

#include <Eigen/Core>
#include <vector>

/// The force of a contact as the pressure that it is.
namespace tumble::solid {

/// Spreads forces over the circles in which bodies touch a part.
class PatchSpreader {
public:
    /// The mesh outlives it.
    explicit PatchSpreader(const HexMesh& mesh);

    /// The push as pushes of many points of the surface, with Hertz' shares: in a circle of radius a the pressure falls
    /// off as sqrt(1 - r^2 / a^2) (Johnson, Contact Mechanics, 3.4). A shear force has the same shares, as in full
    /// sliding (7.2). The circle stands across `normal` (unit, outward), its points lie straight beneath or above it,
    /// three of them along a facet's shorter side, between 80 and 1800 in all. They come in pairs, opposite to each
    /// other. Beyond an edge there is nothing to press on: a point there moves to the edge, its opposite as far towards
    /// the middle. A push at an edge itself keeps its length along it and has no width.
    /// Force and moment stay, to rounding. Where points lie lower than the push (a round side, an edge), the moment of
    /// its shear force is kept by pressure that leans, in proportion to the distance from the middle. As much of the
    /// shear force as would make pressure pull (more shear than 0.53 of the pressure across a right edge; a patch that
    /// is a line) acts at the push's own point. `radius`: m; at 0 all of the push does, and where no facet within
    /// `facing` of `normal` holds it.
    [[nodiscard]] std::vector<Push> spread(const Push& push, const Eigen::Vector3d& normal, double radius) const;

private:
    [[nodiscard]] std::vector<int> facets_within(const Eigen::Vector3d& point, double radius) const;

    const HexMesh& mesh_;
    std::vector<Eigen::Vector3d> centres_; // per facet, m
    std::vector<double> reaches_;          // per facet, m, from its centre to its farthest corner
};

} // namespace tumble::solid
