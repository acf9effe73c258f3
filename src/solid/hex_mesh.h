#pragma once

#include "base/problem.h"
#include "solid/hex8.h"

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

/// A part as hexahedra. Its surface keeps its own numbers: what a contact solver touches as triangle 2f or 2f + 1 is
/// facet f here, and nodes are the same nodes, so that no load has to be looked for by its coordinates.
namespace tumble::solid {

struct Facet {
    std::array<int, 4> corners{}; // into HexMesh::nodes, outward by the right-hand rule
    int hex = 0;
    int face = 0; // of the hexahedron, into face_corners
};

/// Indices count from 0; the numbers that files and messages use stand beside them.
struct HexMesh {
    std::string file;                   // it was read from; empty: made here
    std::vector<Eigen::Vector3d> nodes; // m
    std::vector<std::array<int, 8>> hexes;
    std::vector<int> node_numbers;                     // parallel to nodes
    std::vector<int> hex_numbers;                      // parallel to hexes
    std::map<std::string, std::vector<int>> node_sets; // indices, ascending
    std::vector<Facet> facets; // all faces that belong to one hexahedron alone, by hexahedron and face
    std::map<std::string, std::vector<int>> facet_sets; // indices, ascending

    [[nodiscard]] Corners corners_of(int hex) const;
    /// Outward, of the facet's middle plane; its length is the facet's area, m2.
    [[nodiscard]] Eigen::Vector3d area_of(int facet) const;
    [[nodiscard]] Eigen::Vector3d centre_of(int facet) const;
};

/// Numbers nodes and hexahedra from 1 where they have no numbers yet and finds the facets. Problems, with numbers: a
/// hexahedron that is turned inside out or folded (a Jacobian determinant that is not positive at an integration
/// point) or has a node twice, a face that three hexahedra share, nodes that belong to no hexahedron, no hexahedron at
/// all, coordinates that are not finite, two nodes in one place, bodies that no face joins.
Result<HexMesh> finished(HexMesh mesh);

/// The surface as triangles: facet f is cut into triangles 2f and 2f + 1.
std::vector<std::array<Eigen::Vector3d, 3>> triangles_of(const HexMesh& mesh);

/// m3, of all hexahedra.
double volume_of(const HexMesh& mesh);

} // namespace tumble::solid
