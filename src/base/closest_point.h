#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace tumble {

/// A triangle with what its closest-point question needs, worked out once. Metres.
struct FlatTriangle {
    Eigen::Vector3d a, ab, ac;
    Eigen::Vector3d normal; // unit, right-hand rule of a, b, c
    double ab_ab = 0, ab_ac = 0, ac_ac = 0;
    double per_area2 = 0; // 1 / (4 area^2)
};

inline FlatTriangle flat_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    FlatTriangle t;
    t.a = a;
    t.ab = b - a;
    t.ac = c - a;
    const Eigen::Vector3d cross = t.ab.cross(t.ac);
    t.normal = cross.normalized();
    t.ab_ab = t.ab.squaredNorm();
    t.ab_ac = t.ab.dot(t.ac);
    t.ac_ac = t.ac.squaredNorm();
    t.per_area2 = 1 / cross.squaredNorm();
    return t;
}

/// The part of a triangle: its face, edges ab, bc, ca, corners a, b, c; indices into tables of seven.
enum Region : int { face = 0, edge_ab = 1, edge_bc = 2, edge_ca = 3, corner_a = 4, corner_b = 5, corner_c = 6 };

struct ClosestPoint {
    Eigen::Vector3d away; // m, from the closest point to the point asked about
    double distance2 = 0; // m2
    Region region = face;
};

/// Nearest on the edge from `start` along `way`; `from_start` is the point seen from there.
inline ClosestPoint closest_on_edge(const Eigen::Vector3d& from_start, const Eigen::Vector3d& way, double way2,
                                    Region inner, Region first, Region last) {
    const double share = from_start.dot(way) / way2;
    const Region region = share <= 0 ? first : share >= 1 ? last : inner;
    const Eigen::Vector3d away = from_start - std::clamp(share, 0.0, 1.0) * way;
    return {away, away.squaredNorm(), region};
}

/// Closest point of the triangle. Barycentric coordinates say which edges the point's foot lies beyond (two at most);
/// the nearest boundary point is on one of those, since a convex outline hides its far edges.
inline ClosestPoint closest_point(const FlatTriangle& t, const Eigen::Vector3d& point) {
    const Eigen::Vector3d p = point - t.a;
    const double p_ab = p.dot(t.ab), p_ac = p.dot(t.ac);
    const double v = (t.ac_ac * p_ab - t.ab_ac * p_ac) * t.per_area2;
    const double w = (t.ab_ab * p_ac - t.ab_ac * p_ab) * t.per_area2;
    if (v >= 0 && w >= 0 && v + w <= 1) {
        const double height = p.dot(t.normal);
        return {height * t.normal, height * height, face};
    }
    ClosestPoint best;
    best.distance2 = std::numeric_limits<double>::infinity();
    const auto take = [&](const ClosestPoint& found) {
        if (found.distance2 < best.distance2)
            best = found;
    };
    if (w < 0)
        take(closest_on_edge(p, t.ab, t.ab_ab, edge_ab, corner_a, corner_b));
    if (v + w > 1)
        take(closest_on_edge(p - t.ab, t.ac - t.ab, t.ab_ab - 2 * t.ab_ac + t.ac_ac, edge_bc, corner_b, corner_c));
    if (v < 0)
        take(closest_on_edge(p, t.ac, t.ac_ac, edge_ca, corner_a, corner_c));
    return best;
}

} // namespace tumble
