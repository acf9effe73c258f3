#include "sim3d/wall_surface.h"

#include "scene/bowl_mesh.h"
#include "scene/faults.h"
#include "scene/specimen.h"
#include "sim3d/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

Problem problem_of(std::string what, std::string fix) {
    Problem problem;
    problem.what = std::move(what);
    problem.fix = std::move(fix);
    return problem;
}

void need_positive(Problems& problems, const char* name, double value) {
    if (!(value > 0) || !std::isfinite(value))
        problems.push_back(problem_of(fmt::format("the wall's {} is {}", name, value), "it must be positive"));
}

void need_direction(Problems& problems, const char* name, const Vector3d& value) {
    if (!value.allFinite() || !(value.norm() > 0))
        problems.push_back(
            problem_of(fmt::format("the wall's {} has no direction", name), "give a vector with a length"));
}

Problems faults_of(const scene::PlaneShape& shape) {
    Problems problems;
    need_direction(problems, "normal", shape.normal);
    return problems;
}

/// Where the parts of a shape are right, whether they go together.
template <class Shape> Problems and_whole(Problems problems, const Shape& shape) {
    if (const auto fault = problems.empty() ? scene::fault_of(shape) : std::nullopt)
        problems.push_back(*fault);
    return problems;
}

Problems faults_of(const scene::BoxShape& shape) {
    return and_whole({}, shape);
}

Problems faults_of(const scene::CylinderShape& shape) {
    Problems problems;
    need_direction(problems, "axis", shape.axis);
    need_positive(problems, "length", shape.length);
    need_positive(problems, "radius", shape.radius);
    return problems;
}

Problems faults_of(const scene::DiscShape& shape) {
    Problems problems;
    need_direction(problems, "normal", shape.normal);
    need_positive(problems, "radius", shape.radius);
    return and_whole(std::move(problems), shape);
}

Problems faults_of(const scene::TroughShape& shape) {
    Problems problems;
    need_positive(problems, "radius", shape.radius);
    if (!(shape.flare >= 0 && shape.flare < std::numbers::pi / 2))
        problems.push_back(problem_of(fmt::format("the trough's sides lean by {} rad", shape.flare),
                                      "the flare must be at least 0 and below a right angle"));
    return and_whole(std::move(problems), shape);
}

Problems faults_of(const scene::MeshShape&) {
    return {};
}

template <class Bowl> Problems faults_of_bowl(const Bowl& shape) {
    Problems problems;
    need_positive(problems, "radius", shape.radius);
    return and_whole(std::move(problems), shape);
}

Problems faults_of(const scene::BowlShape& shape) {
    return faults_of_bowl(shape);
}

Problems faults_of(const scene::BowlDiscShape& shape) {
    return faults_of_bowl(shape);
}

Problems faults_of(const scene::SpecimenShape& shape) {
    if (shape.mesh)
        return {};
    return {problem_of("the specimen has no mesh", "make it: scene::with_mesh")};
}

struct Maker {
    const scene::Domain& domain;
    Result<SurfacePartsPtr> operator()(const scene::PlaneShape& shape) const { return plane_parts(shape); }
    Result<SurfacePartsPtr> operator()(const scene::BoxShape& shape) const { return box_parts(shape, domain); }
    Result<SurfacePartsPtr> operator()(const scene::CylinderShape& shape) const {
        return cylinder_parts(shape, domain);
    }
    Result<SurfacePartsPtr> operator()(const scene::DiscShape& shape) const { return disc_parts(shape, domain); }
    Result<SurfacePartsPtr> operator()(const scene::TroughShape& shape) const { return trough_parts(shape); }
    Result<SurfacePartsPtr> operator()(const scene::MeshShape& shape) const { return mesh_parts(shape, domain); }
    Result<SurfacePartsPtr> operator()(const scene::BowlShape& shape) const {
        return mesh_parts(mesh_of(shape), domain);
    }
    Result<SurfacePartsPtr> operator()(const scene::BowlDiscShape& shape) const {
        return mesh_parts(mesh_of(shape), domain);
    }
    Result<SurfacePartsPtr> operator()(const scene::SpecimenShape& shape) const {
        return mesh_parts(mesh_of(shape), domain);
    }
};

/// Point and direction of the axis about which a shape is round; nothing where it is not, as with ribs.
std::optional<std::pair<Vector3d, Vector3d>> axis_of(const scene::WallShape& shape) {
    using Axis = std::pair<Vector3d, Vector3d>;
    if (const auto* disc = std::get_if<scene::DiscShape>(&shape))
        return Axis{disc->centre, disc->normal};
    if (const auto* cylinder = std::get_if<scene::CylinderShape>(&shape))
        return Axis{cylinder->base, cylinder->axis};
    if (const auto* disc = std::get_if<scene::BowlDiscShape>(&shape); disc && disc->ribs.count == 0)
        return Axis{disc->centre, Vector3d::UnitY()};
    if (const auto* bowl = std::get_if<scene::BowlShape>(&shape); bowl && bowl->ribs.count == 0)
        return Axis{bowl->base, Vector3d::UnitY()};
    return std::nullopt;
}

} // namespace

bool turns_in_place(const scene::Wall& wall) {
    const scene::WallMotion& motion = wall.motion;
    const auto axis = axis_of(wall.shape);
    if (!axis || motion.rotations.empty() || !motion.harmonics.empty() || !motion.rockings.empty() ||
        !motion.linears.empty() || !motion.tables.empty())
        return false;
    const Vector3d point = axis->first, direction = axis->second.normalized();
    return std::all_of(motion.rotations.begin(), motion.rotations.end(), [&](const scene::Rotation& part) {
        return part.axis.cross(direction).norm() < 1e-12 &&
               (point - part.centre).cross(direction).norm() <= 1e-12 * (1 + point.norm());
    });
}

Result<WallSurface> WallSurface::make(const scene::WallShape& shape, const scene::Domain& domain) {
    Problems problems = std::visit([](const auto& s) { return faults_of(s); }, shape);
    if (!problems.empty())
        return problems;
    Result<SurfacePartsPtr> parts = std::visit(Maker{domain}, shape);
    if (!parts.ok())
        return parts.problems();
    WallSurface surface;
    surface.parts_ = std::move(*parts);
    return surface;
}

int WallSurface::primitives() const {
    return parts_ ? parts_->primitives() : 0;
}

void WallSurface::primitives_near(const Vector3d& centre, double reach, std::vector<int>& out) const {
    out.clear();
    if (parts_)
        parts_->primitives_near(centre, reach, out);
}

double WallSurface::distance(int primitive, const Vector3d& point) const {
    return parts_->distance(primitive, point);
}

int WallSurface::touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                         std::span<WallTouch> out) const {
    return parts_ ? parts_->touches(centre, radius, primitives, out) : 0;
}

} // namespace tumble::sim3d
