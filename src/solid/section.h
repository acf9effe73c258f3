#pragma once

#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::solid {

/// A point on the line between two nodes: what it has of `from` is 1 - share.
struct CutPoint {
    int from = 0, to = 0;
    double share = 0;

    /// Of values at nodes, linear between them.
    template <class Values> [[nodiscard]] auto of(const Values& values) const {
        return (1 - share) * values[static_cast<std::size_t>(from)] + share * values[static_cast<std::size_t>(to)];
    }
};

/// A plane's cut through a part.
struct Section {
    std::vector<CutPoint> points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> lines; // where the plane cuts faces of hexahedra
};

/// Each hexahedron is cut as six tetrahedra about its diagonal from corner 0 to corner 6; the area is exact where faces
/// are flat. Empty where the plane passes by.
Section section_of(const HexMesh& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

} // namespace tumble::solid
