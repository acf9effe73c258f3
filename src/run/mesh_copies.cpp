#include "run/mesh_copies.h"

#include "base/make_folder.h"
#include "observe/whole_file.h"
#include "solid/msh.h"

#include <fmt/format.h>

namespace tumble::run {

namespace {

/// The file that a wall's triangles or hexahedra were read from, if any.
const std::filesystem::path* file_of(const scene::WallShape& shape) {
    if (const auto* mesh = std::get_if<scene::MeshShape>(&shape))
        return &mesh->file;
    const auto* specimen = std::get_if<scene::SpecimenShape>(&shape);
    const auto* part = specimen ? std::get_if<solid::MeshFile>(&specimen->part) : nullptr;
    return part ? &part->file : nullptr;
}

/// Which of a specimen's formats it is stands in its name.
const char* ending_of(const scene::WallShape& shape, const std::filesystem::path& file) {
    if (std::holds_alternative<scene::MeshShape>(shape))
        return "stl";
    return solid::is_gmsh(file) ? "msh" : "inp";
}

} // namespace

Result<std::vector<MeshCopy>> read_meshes(const scene::Scene& scene) {
    std::vector<MeshCopy> copies;
    for (const scene::Wall& wall : scene.walls) {
        const auto* file = file_of(wall.shape);
        if (!file || names_of(copies).contains(*file))
            continue;
        Result<std::string> content = observe::read_whole(*file);
        if (!content)
            return content.problems();
        // By number, for two folders may hold files of one name.
        copies.push_back(
            {*file, fmt::format("meshes/{}.{}", copies.size(), ending_of(wall.shape, *file)), std::move(*content)});
    }
    return copies;
}

Result<Done> write_meshes(const std::vector<MeshCopy>& copies, const RunFolder& folder) {
    if (copies.empty())
        return Done{};
    if (auto made = make_folder(folder.meshes()); !made)
        return made;
    for (const MeshCopy& copy : copies)
        if (const auto written = observe::write_whole(folder.root / copy.name, copy.content); !written)
            return written;
    return Done{};
}

scene::MeshNames names_of(const std::vector<MeshCopy>& copies) {
    scene::MeshNames names;
    for (const MeshCopy& copy : copies)
        names[copy.from] = copy.name;
    return names;
}

} // namespace tumble::run
