#include "run/mesh_copies.h"

#include "base/make_folder.h"
#include "observe/whole_file.h"

#include <fmt/format.h>

namespace tumble::run {

Result<std::vector<MeshCopy>> read_meshes(const scene::Scene& scene) {
    std::vector<MeshCopy> copies;
    for (const scene::Wall& wall : scene.walls) {
        const auto* mesh = std::get_if<scene::MeshShape>(&wall.shape);
        if (!mesh || names_of(copies).contains(mesh->file))
            continue;
        Result<std::string> content = observe::read_whole(mesh->file);
        if (!content)
            return content.problems();
        // By number, for two folders may hold files of one name.
        copies.push_back({mesh->file, fmt::format("meshes/{}.stl", copies.size()), std::move(*content)});
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
