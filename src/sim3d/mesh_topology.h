#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::sim3d {

/// What a touch on some part of a triangle counts as.
enum class FeatureKind : signed char { patch, edge, corner };

struct MeshFeature {
    int id = 0; // the same for all parts that are one: a flat patch, a straight edge, a corner, their periodic copies
    FeatureKind kind = FeatureKind::patch;
};

/// A mesh with shared vertices and everything that its parts count as, docs/walls.md. In a periodic domain it holds
/// copies half a period beyond, joined to the original where they meet.
struct MeshTopology {
    std::vector<Eigen::Vector3d> vertices;            // m
    std::vector<std::array<int, 3>> triangles;        // into vertices; originals first
    std::vector<std::array<MeshFeature, 7>> features; // per triangle, indexed by Region (closest_point.h)
};

/// Two triangles lie in one patch when the angle between them is below this, rad.
constexpr double flat_angle = 1e-4;
/// Vertices nearer than this share of the mesh's diagonal are one.
constexpr double weld_share = 1e-6;

/// Problems: no triangles, a coordinate that is not finite, triangles without area and triangles there twice, each
/// with its number counted from 1.
Result<MeshTopology> mesh_topology(const scene::MeshShape& shape, const scene::Domain& domain);

} // namespace tumble::sim3d
