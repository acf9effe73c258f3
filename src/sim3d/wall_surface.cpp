#include "sim3d/wall_surface.h"

#include "sim3d/wall_parts.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

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

Problems faults_of(const scene::BoxShape& shape) {
    Problems problems;
    for (int axis = 0; axis < 3; ++axis)
        if (!(shape.box.hi[axis] > shape.box.lo[axis]))
            problems.push_back(problem_of(fmt::format("the box is empty along {}", "xyz"[axis]),
                                          "its hi must be above its lo on every axis"));
    return problems;
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
    if (!(shape.hole_radius >= 0 && shape.hole_radius < shape.radius))
        problems.push_back(
            problem_of(fmt::format("the hole's radius is {} m in a disc of {} m", shape.hole_radius, shape.radius),
                       "it must be at least 0 and smaller than the disc's"));
    return problems;
}

Problems faults_of(const scene::TroughShape& shape) {
    Problems problems;
    need_positive(problems, "radius", shape.radius);
    if (!(shape.rim > shape.floor))
        problems.push_back(
            problem_of(fmt::format("the trough's rim ({} m) is not above its floor ({} m)", shape.rim, shape.floor),
                       "raise the rim"));
    if (!(shape.flare >= 0 && shape.flare < std::numbers::pi / 2))
        problems.push_back(problem_of(fmt::format("the trough's sides lean by {} rad", shape.flare),
                                      "the flare must be at least 0 and below a right angle"));
    return problems;
}

Problems faults_of(const scene::MeshShape&) {
    return {};
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
};

} // namespace

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
