#include "solid/facet_load.h"

#include "base/closest_point.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace tumble::solid {

using Eigen::Vector3d;

namespace {

constexpr double balanced = 1e-9; // share of the forces, and of their moments about the part's middle
// Share of a facet's diagonal. A foot on a flat facet is met to rounding, 1e-15.
constexpr double met = 1e-12;

Vector3d corner_of(const HexMesh& mesh, int facet, Eigen::Index k) {
    return mesh.nodes[static_cast<std::size_t>(
        mesh.facets[static_cast<std::size_t>(facet)].corners[static_cast<std::size_t>(k)])];
}

Vector3d foot_of(const HexMesh& mesh, int facet, const Eigen::Vector4d& shares) {
    Vector3d foot = Vector3d::Zero();
    for (Eigen::Index k = 0; k < 4; ++k)
        foot += shares[k] * corner_of(mesh, facet, k);
    return foot;
}

/// A facet whose corners lie in no plane is touched as its triangles, 0 1 2 and 0 2 3, which the curved one misses:
/// shares of the three corners of that which holds the point, so that force and moment are exact. `shares` where
/// neither is nearer.
Eigen::Vector4d shares_of_triangles(const HexMesh& mesh, int facet, const Vector3d& point,
                                    const Eigen::Vector4d& shares) {
    Eigen::Vector4d best = shares;
    double nearest = (foot_of(mesh, facet, shares) - point).norm();
    const Vector3d a = corner_of(mesh, facet, 0);
    if (nearest <= met * (corner_of(mesh, facet, 2) - a).norm())
        return best;
    for (const Eigen::Index second : {1, 2}) {
        const FlatTriangle triangle =
            flat_triangle(a, corner_of(mesh, facet, second), corner_of(mesh, facet, second + 1));
        const Vector3d off = point - closest_point(triangle, point).away - a;
        const double ab = off.dot(triangle.ab), ac = off.dot(triangle.ac);
        const double v = (triangle.ac_ac * ab - triangle.ab_ac * ac) * triangle.per_area2;
        const double w = (triangle.ab_ab * ac - triangle.ab_ac * ab) * triangle.per_area2;
        Eigen::Vector4d of_three = Eigen::Vector4d::Zero();
        of_three[0] = 1 - v - w;
        of_three[second] = v;
        of_three[second + 1] = w;
        if (const double away = (foot_of(mesh, facet, of_three) - point).norm(); away < nearest) {
            nearest = away;
            best = of_three;
        }
    }
    return best;
}

} // namespace

Eigen::Vector4d shares_at(const HexMesh& mesh, int facet, const Vector3d& point) {
    Eigen::Matrix<double, 3, 4> corners;
    for (int k = 0; k < 4; ++k)
        corners.col(k) = mesh.nodes[static_cast<std::size_t>(
            mesh.facets[static_cast<std::size_t>(facet)].corners[static_cast<std::size_t>(k)])];
    // Gauss-Newton on the distance; a facet that is a parallelogram needs one step.
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    for (int round = 0; round < 20; ++round) {
        const Eigen::Matrix<double, 3, 2> tangents = corners * facet_slopes_at(at.x(), at.y());
        const Vector3d off = point - corners * facet_shape_at(at.x(), at.y());
        const Eigen::Vector2d move = (tangents.transpose() * tangents).inverse() * (tangents.transpose() * off);
        at += move;
        if (move.cwiseAbs().maxCoeff() < 1e-15)
            break;
    }
    at = at.cwiseMax(-1.0).cwiseMin(1.0);
    return facet_shape_at(at.x(), at.y());
}

std::optional<Push> moved_to(const HexMesh& mesh, const Push& push, const Vector3d& normal) {
    std::optional<Push> moved;
    double nearest = std::numeric_limits<double>::infinity(); // m
    for (int f = 0; f < static_cast<int>(mesh.facets.size()); ++f) {
        const auto& corners = mesh.facets[static_cast<std::size_t>(f)].corners;
        const auto node = [&](std::size_t k) -> const Vector3d& {
            return mesh.nodes[static_cast<std::size_t>(corners[k])];
        };
        const double reach = std::max((node(2) - node(0)).norm(), (node(3) - node(1)).norm()) / 2;
        if ((mesh.centre_of(f) - push.point).norm() > nearest + reach || mesh.area_of(f).normalized().dot(normal) < 0.5)
            continue;
        const Eigen::Vector4d shares = shares_at(mesh, f, push.point);
        Vector3d foot = Vector3d::Zero();
        for (std::size_t k = 0; k < 4; ++k)
            foot += shares[static_cast<Eigen::Index>(k)] * node(k);
        if (const double away = (foot - push.point).norm(); away < nearest) {
            nearest = away;
            moved = Push{f, foot, push.force};
        }
    }
    return moved;
}

Result<Eigen::Matrix3Xd> nodal_loads(const HexMesh& mesh, const std::vector<Push>& pushes) {
    Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(mesh.nodes.size()));
    double size = 0, lever = 0, worst = 0;
    Vector3d force_gap = Vector3d::Zero(), moment_gap = Vector3d::Zero();
    int worst_facet = 0;
    for (const Push& push : pushes) {
        if (push.facet < 0 || push.facet >= static_cast<int>(mesh.facets.size()))
            return Problem{.what = fmt::format("a load names facet {} of {}", push.facet, mesh.facets.size()),
                           .fix = "it belongs to another mesh"};
        const Eigen::Vector4d shares =
            shares_of_triangles(mesh, push.facet, push.point, shares_at(mesh, push.facet, push.point));
        Vector3d foot = Vector3d::Zero();
        for (int k = 0; k < 4; ++k) {
            const int node = mesh.facets[static_cast<std::size_t>(push.facet)].corners[static_cast<std::size_t>(k)];
            loads.col(node) += shares[k] * push.force;
            foot += shares[k] * mesh.nodes[static_cast<std::size_t>(node)];
        }
        const Vector3d arm = foot - push.point;
        force_gap += (shares.sum() - 1) * push.force;
        moment_gap += arm.cross(push.force);
        size += push.force.norm();
        lever += (push.point - mesh.nodes.front()).norm() * push.force.norm();
        if (arm.norm() > worst) {
            worst = arm.norm();
            worst_facet = push.facet;
        }
    }
    if (force_gap.norm() <= balanced * size && moment_gap.norm() <= balanced * lever)
        return loads;
    return Problem{
        .what = fmt::format(
            "nodal loads miss {:.3g} N and {:.3g} N m of the contacts': a contact lies {:.3g} "
            "m off facet {} of element {}",
            force_gap.norm(), moment_gap.norm(), worst, worst_facet + 1,
            mesh.hex_numbers[static_cast<std::size_t>(mesh.facets[static_cast<std::size_t>(worst_facet)].hex)]),
        .fix = "loads must lie on the surface of this mesh: run the scene again"};
}

} // namespace tumble::solid
