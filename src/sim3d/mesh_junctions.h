#pragma once

#include "sim3d/mesh_weld.h"

namespace tumble::sim3d {

/// A triangle of a mesh file, or a part of one.
struct MeshPiece {
    std::array<Eigen::Vector3d, 3> corners; // m
    std::size_t triangle = 0;               // in the file, from 0
};

/// Whether the triangle is lower than `tolerance` (m) over its longest edge.
bool without_area(const std::array<Eigen::Vector3d, 3>& corners, double tolerance);

/// Cuts pieces where the end of another triangle stands within one of their edges, nearer than `tolerance` (m): there
/// one sheet's long edge meets two short ones of the next, which share no edge with it. `mesh` is the pieces, welded.
/// Returns whether anything was cut; a piece with such places on two of its edges needs another call.
bool split_at_junctions(const WeldedMesh& mesh, double tolerance, std::vector<MeshPiece>& pieces);

} // namespace tumble::sim3d
