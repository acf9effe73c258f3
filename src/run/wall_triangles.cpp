#include "run/wall_triangles.h"

#include "scene/bowl_mesh.h"
#include "scene/specimen.h"
#include "scene/trough_profile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace tumble::run {

namespace {

using Eigen::Vector3d;
using observe::FrameWall;

constexpr int strips_per_turn = 64;

int add_vertex(FrameWall& wall, const Vector3d& point) {
    wall.vertices.push_back(point);
    return static_cast<int>(wall.vertices.size()) - 1;
}

void add_quad(FrameWall& wall, int a, int b, int c, int d) {
    wall.triangles.push_back({a, b, c});
    wall.triangles.push_back({a, c, d});
}

/// Two unit vectors that span the plane across `axis`, right-handed with it.
std::pair<Vector3d, Vector3d> across(const Vector3d& axis) {
    const Vector3d first = axis.unitOrthogonal();
    return {first, axis.cross(first)};
}

/// Where a plane cuts the box' edges, each corner once.
std::vector<Vector3d> cut_points(const scene::PlaneShape& plane, const scene::Box& box) {
    const double size = (box.hi - box.lo).norm();
    std::vector<Vector3d> points;
    const auto add = [&](const Vector3d& point) {
        const auto same = [&](const Vector3d& other) { return (other - point).norm() < 1e-9 * size; };
        if (std::none_of(points.begin(), points.end(), same))
            points.push_back(point);
    };
    const auto corner = [&](int index) {
        return Vector3d(index & 1 ? box.hi.x() : box.lo.x(), index & 2 ? box.hi.y() : box.lo.y(),
                        index & 4 ? box.hi.z() : box.lo.z());
    };
    for (int from = 0; from < 8; ++from)
        for (int bit = 1; bit < 8; bit *= 2) {
            if (from & bit)
                continue;
            const Vector3d a = corner(from);
            const Vector3d b = corner(from | bit);
            const double above_a = plane.normal.dot(a - plane.point);
            const double above_b = plane.normal.dot(b - plane.point);
            const double near = 1e-9 * size;
            if (std::abs(above_a) < near)
                add(a);
            if (std::abs(above_b) < near)
                add(b);
            if ((above_a < -near && above_b > near) || (above_a > near && above_b < -near))
                add(a + above_a / (above_a - above_b) * (b - a));
        }
    return points;
}

struct Triangulate {
    const scene::Domain& domain;
    FrameWall& wall;

    void operator()(const scene::PlaneShape& plane) const {
        std::vector<Vector3d> points = cut_points(plane, domain.box);
        if (points.size() < 3)
            return;
        Vector3d centre = Vector3d::Zero();
        for (const Vector3d& point : points)
            centre += point / static_cast<double>(points.size());
        const auto [u, v] = across(plane.normal);
        const auto angle = [&, u = u, v = v](const Vector3d& point) {
            return std::atan2(v.dot(point - centre), u.dot(point - centre));
        };
        std::sort(points.begin(), points.end(),
                  [&](const Vector3d& a, const Vector3d& b) { return angle(a) < angle(b); });
        wall.vertices = points;
        for (int i = 1; i + 1 < static_cast<int>(points.size()); ++i)
            wall.triangles.push_back({0, i, i + 1});
    }

    void operator()(const scene::BoxShape& shape) const {
        scene::Box box = shape.box;
        for (int axis = 0; axis < 3; ++axis)
            if (domain.periodic[static_cast<std::size_t>(axis)]) {
                box.lo[axis] = std::max(box.lo[axis], domain.box.lo[axis]);
                box.hi[axis] = std::min(box.hi[axis], domain.box.hi[axis]);
            }
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side)
                if (!shape.open[static_cast<std::size_t>(2 * axis + side)])
                    add_face(box, axis, side);
    }

    void operator()(const scene::CylinderShape& cylinder) const {
        const auto [u, v] = across(cylinder.axis);
        const Vector3d top = cylinder.length * cylinder.axis;
        for (int i = 0; i < strips_per_turn; ++i) {
            const double angle = 2 * std::numbers::pi * i / strips_per_turn;
            const Vector3d rim = cylinder.base + cylinder.radius * (std::cos(angle) * u + std::sin(angle) * v);
            add_vertex(wall, rim);
            add_vertex(wall, rim + top);
        }
        for (int i = 0; i < strips_per_turn; ++i) {
            const int next = (i + 1) % strips_per_turn;
            add_quad(wall, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1);
        }
    }

    void operator()(const scene::DiscShape& disc) const {
        const auto [u, v] = across(disc.normal);
        for (int i = 0; i < strips_per_turn; ++i) {
            const double angle = 2 * std::numbers::pi * i / strips_per_turn;
            const Vector3d out = std::cos(angle) * u + std::sin(angle) * v;
            add_vertex(wall, disc.centre + disc.radius * out);
            if (disc.hole_radius > 0)
                add_vertex(wall, disc.centre + disc.hole_radius * out);
        }
        const int middle = disc.hole_radius > 0 ? -1 : add_vertex(wall, disc.centre);
        for (int i = 0; i < strips_per_turn; ++i) {
            const int next = (i + 1) % strips_per_turn;
            if (middle >= 0)
                wall.triangles.push_back({middle, i, next});
            else
                add_quad(wall, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1);
        }
    }

    void operator()(const scene::TroughShape& trough) const {
        const bool given = trough.x_hi > trough.x_lo;
        const double x_lo = given ? trough.x_lo : domain.box.lo.x();
        const double x_hi = given ? trough.x_hi : domain.box.hi.x();
        const std::vector<Eigen::Vector2d> profile = trough_profile(trough);
        for (const Eigen::Vector2d& point : profile) {
            add_vertex(wall, {x_lo, point.y(), point.x()});
            add_vertex(wall, {x_hi, point.y(), point.x()});
        }
        for (int i = 0; i + 1 < static_cast<int>(profile.size()); ++i)
            add_quad(wall, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
    }

    void operator()(const scene::MeshShape& mesh) const {
        std::map<std::tuple<double, double, double>, int> known;
        for (const std::array<Vector3d, 3>& triangle : mesh.triangles) {
            std::array<int, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector3d& at = triangle[k];
                const auto [entry, fresh] = known.try_emplace({at.x(), at.y(), at.z()}, 0);
                if (fresh)
                    entry->second = add_vertex(wall, at);
                corners[k] = entry->second;
            }
            wall.triangles.push_back(corners);
        }
    }

    void operator()(const scene::BowlShape& bowl) const { (*this)(scene::mesh_of(bowl)); }
    void operator()(const scene::BowlDiscShape& disc) const { (*this)(scene::mesh_of(disc)); }
    void operator()(const scene::SpecimenShape& specimen) const { (*this)(scene::mesh_of(specimen)); }

private:
    void add_face(const scene::Box& box, int axis, int side) const {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        std::array<int, 4> corners{};
        for (int i = 0; i < 4; ++i) {
            Vector3d point;
            point[axis] = side ? box.hi[axis] : box.lo[axis];
            point[u] = i == 1 || i == 2 ? box.hi[u] : box.lo[u];
            point[v] = i >= 2 ? box.hi[v] : box.lo[v];
            corners[static_cast<std::size_t>(i)] = add_vertex(wall, point);
        }
        add_quad(wall, corners[0], corners[1], corners[2], corners[3]);
    }

    /// (z, y) from the rim at negative z over the bottom to the other rim; a rim below the arc's end cuts the arc.
    static std::vector<Eigen::Vector2d> trough_profile(const scene::TroughShape& trough) {
        const scene::TroughProfile half = scene::profile_of(trough);
        std::vector<Eigen::Vector2d> profile;
        if (half.side)
            profile.emplace_back(-half.rim_half, trough.rim);
        constexpr int strips = strips_per_turn / 2;
        for (int i = 0; i <= strips; ++i) {
            const double angle = half.arc_end * (2.0 * i / strips - 1);
            profile.emplace_back(trough.radius * std::sin(angle), half.centre - trough.radius * std::cos(angle));
        }
        if (half.side)
            profile.emplace_back(half.rim_half, trough.rim);
        return profile;
    }
};

} // namespace

observe::FrameWall wall_triangles(const scene::Wall& wall, const scene::Domain& domain) {
    FrameWall surface;
    surface.name = wall.name;
    surface.opacity = wall.opacity;
    std::visit(Triangulate{domain, surface}, wall.shape);
    return surface;
}

} // namespace tumble::run
