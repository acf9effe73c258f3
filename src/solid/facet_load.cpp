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

constexpr double balanced = 1e-9; // share of the forces, and of their moments about the part's first node
// Share of a facet's diagonal. A foot on a flat facet is met to rounding, 1e-15.
constexpr double met = 1e-12;

const Vector3d& corner_of(const HexMesh& mesh, int facet, Eigen::Index k) {
    return mesh.nodes[static_cast<std::size_t>(
        mesh.facets[static_cast<std::size_t>(facet)].corners[static_cast<std::size_t>(k)])];
}

/// A facet whose corners lie in no plane is touched as its triangles, 0 1 2 and 0 2 3, which the curved one misses:
/// shares of the three corners of that which holds the point, so that force and moment are exact. `shares` where
/// neither is nearer.
Eigen::Vector4d shares_of_triangles(const HexMesh& mesh, int facet, const Vector3d& point,
                                    const Eigen::Vector4d& shares) {
    Eigen::Vector4d best = shares;
    double nearest = (point_of(mesh, facet, shares) - point).norm();
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
        if (const double away = (point_of(mesh, facet, of_three) - point).norm(); away < nearest) {
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

Vector3d point_of(const HexMesh& mesh, int facet, const Eigen::Vector4d& shares) {
    Vector3d point = Vector3d::Zero();
    for (Eigen::Index k = 0; k < 4; ++k)
        point += shares[k] * corner_of(mesh, facet, k);
    return point;
}

std::optional<Push> moved_to(const HexMesh& mesh, const Push& push, const Vector3d& normal) {
    std::optional<Push> moved;
    double nearest = std::numeric_limits<double>::infinity(); // m
    for (int f = 0; f < static_cast<int>(mesh.facets.size()); ++f) {
        const auto node = [&](Eigen::Index k) -> const Vector3d& { return corner_of(mesh, f, k); };
        const double reach = std::max((node(2) - node(0)).norm(), (node(3) - node(1)).norm()) / 2;
        if ((mesh.centre_of(f) - push.point).norm() > nearest + reach ||
            mesh.area_of(f).normalized().dot(normal) < facing)
            continue;
        const Vector3d foot = point_of(mesh, f, shares_at(mesh, f, push.point));
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
        for (int k = 0; k < 4; ++k)
            loads.col(mesh.facets[static_cast<std::size_t>(push.facet)].corners[static_cast<std::size_t>(k)]) +=
                shares[k] * push.force;
        const Vector3d arm = point_of(mesh, push.facet, shares) - push.point;
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

std::optional<Problem> imbalance(const HexMesh& mesh, const Eigen::Matrix3Xd& loads,
                                 const std::vector<Push>& contacts) {
    const Vector3d& about = mesh.nodes.front(); // near the part, so that its place costs no digits
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vector3d load = loads.col(static_cast<Eigen::Index>(n));
        force += load;
        moment += (mesh.nodes[n] - about).cross(load);
    }
    double size = 0, lever = 0;
    for (const Push& contact : contacts) {
        const Vector3d arm = contact.point - about;
        force -= contact.force;
        moment -= arm.cross(contact.force);
        size += contact.force.norm();
        lever += arm.norm() * contact.force.norm();
    }
    if (force.norm() <= balanced * size && moment.norm() <= balanced * lever)
        return std::nullopt;
    return Problem{.what = fmt::format("forces on the nodes miss {:.3g} N and {:.3g} N m of the contacts'",
                                       force.norm(), moment.norm()),
                   .fix = "let forces act at points: --patch 0"};
}

} // namespace tumble::solid
