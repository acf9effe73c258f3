#include "fem/first_wall.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::fem {

using Eigen::Vector3d;

namespace {

constexpr int most_steps = 2000; // of a way: slivers of a mesh from a file do not make it endless

double shortest_edge(const solid::HexMesh& mesh) {
    double least = std::numeric_limits<double>::infinity(); // m
    for (const solid::Facet& facet : mesh.facets)
        for (std::size_t k = 0; k < 4; ++k)
            least = std::min(least, (mesh.nodes[static_cast<std::size_t>(facet.corners[k])] -
                                     mesh.nodes[static_cast<std::size_t>(facet.corners[(k + 1) % 4])])
                                        .norm());
    return least;
}

} // namespace

std::optional<Problem> beyond_first_wall(const Slice& slice, const solid::HexMesh& mesh,
                                         const solid::Locator& locator) {
    const double step = std::max(0.5 * shortest_edge(mesh), slice.depth / most_steps); // m
    for (const SlicePoint& point : slice.points) {
        const Vector3d& above = mesh.nodes[static_cast<std::size_t>(point.node)];
        bool entered = false; // a hollow side may let the way begin outside
        for (double way = step; way < slice.depth; way += step) {
            const bool within = locator.find(above + way / slice.depth * (point.place - above)).has_value();
            if (entered && !within)
                return Problem{.what = fmt::format("{:.4g} m beneath side '{}' at node {} lies behind a gap: the "
                                                   "part's first wall ends {:.3g} m beneath",
                                                   slice.depth, slice.side,
                                                   mesh.node_numbers[static_cast<std::size_t>(point.node)], way),
                               .fix = "take a smaller depth"};
            entered = entered || within;
        }
    }
    return std::nullopt;
}

} // namespace tumble::fem
