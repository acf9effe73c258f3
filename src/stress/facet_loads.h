#pragma once

#include "observe/part_loads.h"
#include "run/part_loads.h"
#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

/// What contacts do to a part's facets.
namespace tumble::stress {

/// Which facet a contact counts for: at an edge or corner, where several meet, the one that faces the body most, else
/// that of its triangle.
class FacetFinder {
public:
    /// The mesh outlives it.
    explicit FacetFinder(const solid::HexMesh& mesh);

    [[nodiscard]] int facet_of(const observe::WallPush& push) const;
    [[nodiscard]] const solid::HexMesh& mesh() const { return mesh_; }

private:
    const solid::HexMesh& mesh_;
    std::vector<Eigen::Vector3d> normals_;         // per facet, outward
    std::vector<std::vector<int>> facets_of_node_; // per node
};

/// What an instant's contacts do to a facet, along and across the facet's normal, which at an edge is not theirs.
struct FacetLoad {
    double pressing = 0;                                // N
    Eigen::Vector3d shearing = Eigen::Vector3d::Zero(); // N
};
/// By facet of the mesh.
std::map<int, FacetLoad> facet_loads(const std::vector<observe::WallPush>& pushes, const FacetFinder& finder);

/// facet_loads() over the facets' areas, of all instants, as facets.csv has them.
std::string facets_csv(const run::PartLoads& loads, const solid::HexMesh& mesh);

} // namespace tumble::stress
