#include "solid/hertz_patch.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::solid {

namespace {

using Eigen::Vector3d;

constexpr int rings = 5, spokes = 12;
constexpr int halvings = 6; // below a 64th of its radius a patch is a point

/// Points of the unit circle that bear equal shares of Hertz' force: within r lies 1 - (1 - r^2)^(3/2) of it. Each
/// ring stands at the middle of its share, turned by half a spoke against its neighbours.
const std::vector<Eigen::Vector2d>& circle() {
    static const std::vector<Eigen::Vector2d> points = [] {
        std::vector<Eigen::Vector2d> made;
        for (int ring = 0; ring < rings; ++ring) {
            const double within = (ring + 0.5) / rings, r = std::sqrt(1 - std::cbrt((1 - within) * (1 - within)));
            for (int spoke = 0; spoke < spokes; ++spoke) {
                const double angle = 2 * std::numbers::pi * (spoke + 0.5 * (ring % 2)) / spokes;
                made.emplace_back(r * std::cos(angle), r * std::sin(angle));
            }
        }
        return made;
    }();
    return points;
}

/// Scales the pushes' shares, linearly across the patch, so that they add up to 1 and their middle across the normal is
/// the push's. Nothing where a share would fall below 0.
bool balance(std::vector<Push>& points, const Push& push, const Vector3d& along, const Vector3d& across,
             double radius) {
    const auto place_of = [&](const Push& point) {
        const Vector3d off = (point.point - push.point) / radius;
        return Vector3d(1, off.dot(along), off.dot(across));
    };
    const double share = 1.0 / static_cast<double>(points.size());
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Push& point : points)
        moments += share * place_of(point) * place_of(point).transpose();
    const Eigen::FullPivLU<Eigen::Matrix3d> solver(moments);
    if (!solver.isInvertible())
        return false;
    const Vector3d slopes = solver.solve(Vector3d::UnitX());
    for (Push& point : points) {
        const double factor = slopes.dot(place_of(point));
        if (!(factor >= 0))
            return false;
        point.force = factor * share * push.force;
    }
    return true;
}

} // namespace

PatchSpreader::PatchSpreader(const HexMesh& mesh) : mesh_(mesh) {
    for (int f = 0; f < static_cast<int>(mesh.facets.size()); ++f) {
        centres_.push_back(mesh.centre_of(f));
        double reach = 0;
        for (const int node : mesh.facets[static_cast<std::size_t>(f)].corners)
            reach = std::max(reach, (mesh.nodes[static_cast<std::size_t>(node)] - centres_.back()).norm());
        reaches_.push_back(reach);
    }
}

std::vector<int> PatchSpreader::facets_within(const Vector3d& point, double radius) const {
    std::vector<int> facets;
    for (std::size_t f = 0; f < centres_.size(); ++f) {
        const double reach = radius + reaches_[f];
        if ((centres_[f] - point).squaredNorm() <= reach * reach)
            facets.push_back(static_cast<int>(f));
    }
    return facets;
}

std::vector<Push> PatchSpreader::spread(const Push& push, const Vector3d& normal, double radius) const {
    if (!(radius > 0))
        return {push};
    const Vector3d along = normal.unitOrthogonal(), across = normal.cross(along);
    // Twice the radius: what is nearest to a point of the circle may lie beside it where the surface is round.
    const std::vector<int> facets = facets_within(push.point, 2 * radius);
    for (int halving = 0; halving < halvings; ++halving, radius /= 2) {
        std::vector<Push> points;
        for (const Eigen::Vector2d& at : circle()) {
            const Vector3d place = push.point + radius * (at.x() * along + at.y() * across);
            if (auto moved = moved_to(mesh_, facets, {push.facet, place, push.force}, normal))
                points.push_back(*moved);
        }
        if (points.size() == circle().size() && balance(points, push, along, across, radius))
            return points;
    }
    return {push};
}

} // namespace tumble::solid
