#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::sim3d {

/// Triangles over shared vertices, with periodic copies behind the originals.
struct WeldedMesh {
    std::vector<Eigen::Vector3d> vertices;     // m
    std::vector<std::array<int, 3>> triangles; // into vertices
    std::vector<int> original;                 // per triangle: the one that it copies, or itself
    /// Copies that coincided with a triangle already there: that triangle, and the original of the copy. Corners may
    /// stand in another order.
    std::vector<std::array<int, 2>> coincident;
};

/// Problems as mesh_topology says.
Result<WeldedMesh> weld_mesh(const scene::MeshShape& shape, const scene::Domain& domain);

} // namespace tumble::sim3d
