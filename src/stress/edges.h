#pragma once

#include "solid/hex_mesh.h"

#include <vector>

namespace tumble::stress {

/// Where a part's surface bends sharply: between its sides and ends, about a bore's mouth. The facets of a round side
/// with nine or more of them about the axis have no edge between them.
class Edges {
public:
    explicit Edges(const solid::HexMesh& mesh);

    /// m, to the nearest; infinite where the part has none.
    [[nodiscard]] double distance(const Eigen::Vector3d& place) const;

private:
    struct Line {
        Eigen::Vector3d from, way; // m
    };
    std::vector<Line> lines_;
};

} // namespace tumble::stress
