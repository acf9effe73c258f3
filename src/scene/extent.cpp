#include "scene/extent.h"

#include "scene/outline.h"
#include "scene/trough_profile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::scene {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Extent of a lateral surface or rim: a circle of `radius` about unit `axis`.
Vector3d circle_reach(const Vector3d& axis, double radius) {
    return radius * (Vector3d::Ones() - axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
}

struct Extent {
    Box operator()(const PlaneShape&) const { return {Vector3d::Constant(-endless), Vector3d::Constant(endless)}; }
    Box operator()(const BoxShape& shape) const { return shape.box; }
    Box operator()(const CylinderShape& shape) const {
        const Vector3d axis = shape.axis.normalized();
        const Vector3d end = shape.base + axis * shape.length;
        const Vector3d reach = circle_reach(axis, shape.radius);
        return {shape.base.cwiseMin(end) - reach, shape.base.cwiseMax(end) + reach};
    }
    Box operator()(const DiscShape& shape) const {
        const Vector3d reach = circle_reach(shape.normal.normalized(), shape.radius);
        return {shape.centre - reach, shape.centre + reach};
    }
    Box operator()(const TroughShape& shape) const {
        const double half = profile_of(shape).rim_half;
        return {{-endless, shape.floor, -half}, {endless, shape.rim, half}};
    }
    Box operator()(const BowlShape& shape) const { return upright(shape.base, shape.radius, shape.height); }
    Box operator()(const BowlDiscShape& shape) const {
        return upright(shape.centre, shape.radius,
                       std::max(shape.rim_rise, shape.ribs.count > 0 ? shape.ribs.height : 0));
    }
    Box operator()(const SpecimenShape& shape) const {
        Eigen::AlignedBox3d all;
        for (const Vector3d& node : shape.mesh->nodes)
            all.extend(node);
        return {all.min(), all.max()};
    }
    Box operator()(const MeshShape& shape) const {
        Box all{Vector3d::Constant(endless), Vector3d::Constant(-endless)};
        for (const auto& triangle : shape.triangles)
            for (const Vector3d& corner : triangle) {
                all.lo = all.lo.cwiseMin(corner);
                all.hi = all.hi.cwiseMax(corner);
            }
        return all;
    }

private:
    static Box upright(const Vector3d& base, double radius, double height) {
        return {base - Vector3d(radius, 0, radius), base + Vector3d(radius, height, radius)};
    }
};

} // namespace

Box extent_of(const WallShape& shape) {
    return std::visit(Extent{}, shape);
}

Box extent_of(const Wall& wall, int dimension) {
    if (dimension == 3)
        return extent_of(wall.shape);
    const Rectangle flat = bounds_of(pieces_of(wall.outline));
    return {{flat.lo.x(), flat.lo.y(), 0}, {flat.hi.x(), flat.hi.y(), 0}};
}

Box widened(const Box& box, double by) {
    return {box.lo - Vector3d::Constant(by), box.hi + Vector3d::Constant(by)};
}

Box reached_domain(const Wall& wall, const Scene& scene) {
    const Box& domain = scene.domain.box;
    const Vector3d middle = (domain.lo + domain.hi) / 2;
    double way = speed_bound(wall.motion, middle, (domain.hi - domain.lo).norm()) * scene.duration;
    for (const MotionTable& table : wall.motion.tables)
        way += table.displacement.empty() ? 0 : table.displacement.front().norm();
    return widened(domain, way);
}

bool overlap(const std::array<Vector3d, 3>& triangle, const Box& box) {
    const Vector3d middle = (box.lo + box.hi) / 2;
    const Vector3d half = (box.hi - box.lo) / 2;
    const std::array<Vector3d, 3> corners{triangle[0] - middle, triangle[1] - middle, triangle[2] - middle};
    const auto apart = [&](const Vector3d& axis) {
        const double a = axis.dot(corners[0]), b = axis.dot(corners[1]), c = axis.dot(corners[2]);
        const double reach = half.dot(axis.cwiseAbs());
        return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
    };
    const std::array<Vector3d, 3> edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
    for (int k = 0; k < 3; ++k) {
        if (apart(Vector3d::Unit(k)))
            return false;
        for (const Vector3d& edge : edges)
            if (apart(Vector3d::Unit(k).cross(edge)))
                return false;
    }
    return !apart(edges[0].cross(edges[1]));
}

} // namespace tumble::scene
