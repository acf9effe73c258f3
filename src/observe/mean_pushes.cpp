#include "observe/mean_pushes.h"

#include <algorithm>
#include <cmath>

namespace tumble::observe {

namespace {

using Eigen::Vector3d;

constexpr int most_halvings = 6;        // what touches lightly has a small patch, and counts little
constexpr double lattice_a_patch = 0.5; // of its radius
constexpr double rounding = 1e-12;      // of a lattice's side

/// How often a triangle's sides are halved for such a patch.
int halvings_of(const FlatTriangle& triangle, double patch) {
    const double side = std::sqrt(std::max(triangle.ab_ab, triangle.ac_ac));
    int halvings = 0;
    while (halvings < most_halvings && side > lattice_a_patch * patch * (1 << halvings))
        ++halvings;
    return halvings;
}

/// A place on one side of the lattice: the line before it, and how far past that it is.
struct Past {
    int line = 0;
    double rest = 0;
};
Past past(double place, int lines) {
    const int line = std::clamp(static_cast<int>(std::floor(place)), 0, std::max(0, lines - 1));
    const double rest = place - line, whole = std::round(rest);
    return {line, std::abs(rest - whole) < rounding ? whole : rest};
}

} // namespace

MeanPushes::MeanPushes(const std::vector<std::array<Vector3d, 3>>& triangles) {
    for (const auto& [a, b, c] : triangles)
        triangles_.push_back(flat_triangle(a, b, c));
}

void MeanPushes::take(const std::vector<WallPush>& pushes) {
    ++steps_;
    for (const WallPush& push : pushes) {
        const FlatTriangle& t = triangles_[static_cast<std::size_t>(push.triangle)];
        const int halvings = halvings_of(t, push.patch), lines = 1 << halvings;
        const Vector3d off = push.foot - t.a;
        const double ab = off.dot(t.ab), ac = off.dot(t.ac);
        const Past v = past(lines * (t.ac_ac * ab - t.ab_ac * ac) * t.per_area2, lines);
        const Past w = past(lines * (t.ab_ab * ac - t.ab_ac * ab) * t.per_area2, lines - v.line);
        const auto at = [&](int along, int across, double share) {
            add({push.triangle, halvings, v.line + along, w.line + across}, share, push);
        };
        if (v.rest + w.rest <= 1 ||
            v.line + w.line + 1 >= lines) { // the cell's half next to a; at bc there is no other
            at(0, 0, 1 - v.rest - w.rest);
            at(1, 0, v.rest);
            at(0, 1, w.rest);
        } else {
            at(1, 1, v.rest + w.rest - 1);
            at(0, 1, 1 - v.rest);
            at(1, 0, 1 - w.rest);
        }
    }
}

bool MeanPushes::fits() const {
    return std::all_of(sums_.begin(), sums_.end(), [&](const auto& one) {
        const auto& [triangle, halvings, along, across] = one.first;
        return triangle >= 0 && triangle < static_cast<int>(triangles_.size()) && halvings >= 0 &&
               halvings <= most_halvings;
    });
}

void MeanPushes::add(const Key& key, double share, const WallPush& push) {
    if (share == 0)
        return;
    Sum& sum = sums_[key];
    const double weight = std::abs(share) * push.force.norm();
    sum.force += share * push.force;
    sum.normal += weight * push.normal;
    sum.patch += weight * push.patch;
    sum.weight += weight;
}

std::vector<WallPush> MeanPushes::finish() {
    std::vector<WallPush> means;
    for (const auto& [key, sum] : sums_) {
        if (!(sum.weight > 0))
            continue;
        const auto& [triangle, halvings, along, across] = key;
        const FlatTriangle& t = triangles_[static_cast<std::size_t>(triangle)];
        const double lines = 1 << halvings;
        WallPush mean;
        mean.body = -1;
        mean.triangle = triangle;
        mean.foot = t.a + along / lines * t.ab + across / lines * t.ac;
        mean.normal = sum.normal.normalized();
        mean.force = sum.force / static_cast<double>(steps_);
        mean.patch = sum.patch / sum.weight;
        means.push_back(mean);
    }
    sums_.clear();
    steps_ = 0;
    return means;
}

} // namespace tumble::observe
