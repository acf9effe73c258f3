#include "scene/specimen.h"

#include <fmt/format.h>

namespace tumble::scene {

Result<SpecimenShape> with_mesh(SpecimenShape specimen) {
    Result<solid::HexMesh> mesh =
        std::visit([&](const auto& part) { return solid::mesh_of(part, specimen.place); }, specimen.part);
    if (!mesh)
        return mesh.problems();
    if (std::holds_alternative<solid::MeshFile>(specimen.part) && !mesh->node_sets.contains(specimen.held_set)) {
        std::string names;
        for (const auto& [name, nodes] : mesh->node_sets)
            names += (names.empty() ? "" : ", ") + name;
        return Problem{.key = "held_set",
                       .what = fmt::format("{} has no node set '{}'", mesh->file, specimen.held_set),
                       .fix = names.empty() ? "name the nodes that are held in the file: *NSET, NSET=HELD, or a "
                                              "physical group of gmsh"
                                            : "it has " + names};
    }
    specimen.mesh = std::make_shared<const solid::HexMesh>(std::move(*mesh));
    return specimen;
}

MeshShape mesh_of(const SpecimenShape& specimen) {
    MeshShape surface;
    surface.triangles = solid::triangles_of(*specimen.mesh);
    return surface;
}

std::vector<std::string> held_sets(const SpecimenShape& specimen) {
    if (std::holds_alternative<solid::MeshFile>(specimen.part))
        return {specimen.held_set};
    if (specimen.held == Held::both)
        return {"base", "top"};
    return {words_of_held[static_cast<std::size_t>(specimen.held)]};
}

} // namespace tumble::scene
