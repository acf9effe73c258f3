#include "stress/edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tumble::stress {

using Eigen::Vector3d;

namespace {

constexpr double sharp = 0.766; // cosine of 40 degrees between the facets' normals, as those of a polygon of nine sides

} // namespace

Edges::Edges(const solid::HexMesh& mesh) {
    std::map<std::pair<int, int>, std::vector<int>> facets; // by the line's nodes
    for (std::size_t f = 0; f < mesh.facets.size(); ++f)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& corners = mesh.facets[f].corners;
            facets[std::minmax({corners[k], corners[(k + 1) % 4]})].push_back(static_cast<int>(f));
        }
    for (const auto& [nodes, beside] : facets) {
        const Vector3d first = mesh.area_of(beside.front()).normalized();
        if (std::none_of(beside.begin(), beside.end(),
                         [&](int f) { return mesh.area_of(f).normalized().dot(first) < sharp; }))
            continue;
        const Vector3d& from = mesh.nodes[static_cast<std::size_t>(nodes.first)];
        lines_.push_back({from, mesh.nodes[static_cast<std::size_t>(nodes.second)] - from});
    }
}

double Edges::distance(const Vector3d& place) const {
    double nearest = std::numeric_limits<double>::infinity(); // m2
    for (const auto& [from, way] : lines_) {
        const Vector3d off = place - from;
        const double share = std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (off - share * way).squaredNorm());
    }
    return std::sqrt(nearest);
}

} // namespace tumble::stress
