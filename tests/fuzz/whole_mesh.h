#pragma once

#include "expect.h"
#include "solid/hex_mesh.h"

namespace fuzz {

/// What every mesh that is let through holds.
inline void expect_whole(const tumble::solid::HexMesh& mesh) {
    const auto there = [&](int node) { return node >= 0 && static_cast<std::size_t>(node) < mesh.nodes.size(); };
    expect(!mesh.hexes.empty() && mesh.facets.size() >= 6, "a part has a surface");
    expect(mesh.node_numbers.size() == mesh.nodes.size() && mesh.hex_numbers.size() == mesh.hexes.size(),
           "every node and hexahedron has a number");
    for (const auto& hex : mesh.hexes)
        for (const int node : hex)
            expect(there(node), "hexahedra have nodes that are there");
    for (const auto& [name, nodes] : mesh.node_sets)
        for (const int node : nodes)
            expect(there(node), "sets have nodes that are there");
    for (const auto& node : mesh.nodes)
        expect(node.allFinite(), "nodes are finite");
    expect(tumble::solid::volume_of(mesh) > 0, "a part has a volume");
}

} // namespace fuzz
