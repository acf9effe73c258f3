#pragma once

#include "base/rng.h"
#include "sim3d/wall_surface.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

/// Triangles of simple things, and what a sphere touches of them.
namespace tumble::sim3d::testing {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using Triangles = std::vector<std::array<Vector3d, 3>>;

constexpr double pi = std::numbers::pi;

inline scene::Domain domain_of(std::array<bool, 3> periodic = {}) {
    scene::Domain domain;
    domain.box = {Vector3d(-1, -1, -1), Vector3d(1, 1, 1)};
    domain.periodic = periodic;
    return domain;
}

inline WallSurface surface_of(const Triangles& triangles, std::array<bool, 3> periodic = {}) {
    return WallSurface::make(scene::MeshShape{"wall.stl", triangles}, domain_of(periodic)).value();
}

inline std::vector<WallTouch> touches(const WallSurface& surface, const Vector3d& centre, double radius) {
    std::vector<int> near;
    surface.primitives_near(centre, radius, near);
    std::array<WallTouch, 16> out;
    const int count = surface.touches(centre, radius, near, out);
    return {out.begin(), out.begin() + count};
}

inline double nearest_of(const WallSurface& surface, const Vector3d& centre) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int primitive = 0; primitive < surface.primitives(); ++primitive)
        nearest = std::min(nearest, surface.distance(primitive, centre));
    return nearest;
}

/// A rectangle from `corner` along u and v, cut into n x m quads whose diagonals lie either way.
inline void add_sheet(Triangles& triangles, const Vector3d& corner, const Vector3d& u, const Vector3d& v, int n, int m,
                      Rng& rng) {
    const auto at = [&](int i, int j) { return Vector3d(corner + u * i / n + v * j / m); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            const Vector3d a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (rng.uniform() < 0.5) {
                triangles.push_back({a, b, c});
                triangles.push_back({a, c, d});
            } else {
                triangles.push_back({a, b, d});
                triangles.push_back({d, b, c}); // some the other way round: STL files mix them
            }
        }
}

inline Triangles box_mesh(const Vector3d& lo, const Vector3d& hi, int n, Rng& rng) {
    Triangles triangles;
    const Vector3d size = hi - lo;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3d u = size[(axis + 1) % 3] * Vector3d::Unit((axis + 1) % 3);
        const Vector3d v = size[(axis + 2) % 3] * Vector3d::Unit((axis + 2) % 3);
        add_sheet(triangles, lo, u, v, n, n, rng);
        add_sheet(triangles, lo + size[axis] * Vector3d::Unit(axis), u, v, n, n, rng);
    }
    return triangles;
}

inline Triangles icosphere(double radius, int rounds) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    const std::array<Vector3d, 12> p{Vector3d(-1, g, 0), Vector3d(1, g, 0), Vector3d(-1, -g, 0), Vector3d(1, -g, 0),
                                     Vector3d(0, -1, g), Vector3d(0, 1, g), Vector3d(0, -1, -g), Vector3d(0, 1, -g),
                                     Vector3d(g, 0, -1), Vector3d(g, 0, 1), Vector3d(-g, 0, -1), Vector3d(-g, 0, 1)};
    Triangles triangles;
    // The faces of an icosahedron are the triples of corners at the smallest mutual distance, 2.
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = i + 1; j < 12; ++j)
            for (std::size_t k = j + 1; k < 12; ++k)
                if ((p[i] - p[j]).norm() < 2.1 && (p[j] - p[k]).norm() < 2.1 && (p[k] - p[i]).norm() < 2.1)
                    triangles.push_back(
                        {p[i].normalized() * radius, p[j].normalized() * radius, p[k].normalized() * radius});
    for (int round = 0; round < rounds; ++round) {
        Triangles finer;
        for (const auto& [a, b, c] : triangles) {
            const auto between = [&](const Vector3d& s, const Vector3d& t) {
                return Vector3d((s + t).normalized() * radius);
            };
            const Vector3d ab = between(a, b), bc = between(b, c), ca = between(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    return triangles;
}

/// The U of a trough made of flat strips along x, as STL exporters do it.
inline Triangles trough_strip(double x_lo, double x_hi, int along, Rng& rng) {
    Triangles triangles;
    const double radius = 0.24;
    for (int k = 0; k < 36; ++k) {
        const double a = pi * k / 36, b = pi * (k + 1) / 36;
        const Vector3d from(x_lo, -radius * std::sin(a), -radius * std::cos(a)),
            to(x_lo, -radius * std::sin(b), -radius * std::cos(b));
        add_sheet(triangles, from, Vector3d(x_hi - x_lo, 0, 0), to - from, along, 1, rng);
    }
    return triangles;
}

inline Vector3d random_direction(Rng& rng) {
    const double y = rng.uniform(-1, 1), angle = rng.uniform(0, 2 * pi), flat = std::sqrt(1 - y * y);
    return {flat * std::cos(angle), y, flat * std::sin(angle)};
}

inline std::string problems_of(const Triangles& triangles) {
    const auto result = WallSurface::make(scene::MeshShape{"wall.stl", triangles}, domain_of());
    return to_string(result.problems());
}

} // namespace tumble::sim3d::testing
