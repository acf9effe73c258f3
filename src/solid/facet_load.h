#pragma once

#include "base/problem.h"
#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

/// What touches a part, as forces on its nodes.
namespace tumble::solid {

/// A force at a point of the surface, N and m, in the part's frame.
struct Push {
    int facet = 0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

/// Derivatives of facet_shape_at by r and s, a row a corner.
inline Eigen::Matrix<double, 4, 2> facet_slopes_at(double r, double s) {
    Eigen::Matrix<double, 4, 2> slopes;
    slopes << -(1 - s), -(1 - r), 1 - s, -(1 + r), 1 + s, 1 + r, -(1 + s), 1 - r;
    return 0.25 * slopes;
}

/// Shares of a facet's corners in a force at the facet's point nearest to `point`: the values of their shape functions
/// there, so that the force does the same work on the brick's displacements. They add up to 1; inside a flat facet
/// they bear the same moment.
Eigen::Vector4d shares_at(const HexMesh& mesh, int facet, const Eigen::Vector3d& point);

/// The facet's point, m, with these shares.
Eigen::Vector3d point_of(const HexMesh& mesh, int facet, const Eigen::Vector4d& shares);

/// Least cosine between the normals of a contact and of a facet that it can act on, 60 degrees: at an edge a body
/// touches aslant.
inline constexpr double facing = 0.5;

/// A push that was recorded on another mesh of the same surface, moved to the nearest point of this one's facets that
/// look the same way (`facing`) as `normal` (unit, outward there); nothing where none does.
std::optional<Push> moved_to(const HexMesh& mesh, const Push& push, const Eigen::Vector3d& normal);

/// Forces of the pushes on the nodes: 3 x nodes, N. Problems: facets that do not exist; nodal forces whose sum or
/// moment differs from that of the pushes by more than 1e-9 of what they add up to (a point off its facet), with the
/// difference and the worst facet.
Result<Eigen::Matrix3Xd> nodal_loads(const HexMesh& mesh, const std::vector<Push>& pushes);

/// What nodal forces miss of the sum and moment of the contacts that they stand for, beyond 1e-9 of what those add up
/// to; nothing where they bear them.
std::optional<Problem> imbalance(const HexMesh& mesh, const Eigen::Matrix3Xd& loads, const std::vector<Push>& contacts);

} // namespace tumble::solid
