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

    /// The push as pushes of 60 points of the surface, all along its force, with Hertz' shares: in a circle of radius
    /// a the pressure falls off as sqrt(1 - r^2 / a^2) (Johnson, Contact Mechanics, 3.4). A shear force has the same
    /// shares, as in full sliding (7.2). Points lie on the facets nearest to the circle, which stands across `normal`
    /// (unit, outward); their shares are corrected so that the force stays and, where the surface is flat, the moment
    /// too; where it is round the points lie lower than the push by up to a^2 / 2R. At an edge that the circle
    /// juts out over it is made smaller, by half again and again, until no share is below 0. `radius`: m; at 0 the
    /// push itself.
    [[nodiscard]] std::vector<Push> spread(const Push& push, const Eigen::Vector3d& normal, double radius) const;

private:
    [[nodiscard]] std::vector<int> facets_within(const Eigen::Vector3d& point, double radius) const;

    const HexMesh& mesh_;
    std::vector<Eigen::Vector3d> centres_; // per facet, m
    std::vector<double> reaches_;          // per facet, m, from its centre to its farthest corner
};

} // namespace tumble::solid
