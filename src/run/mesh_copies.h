#pragma once

#include "base/problem.h"
#include "run/run_folder.h"
#include "scene/scene.h"
#include "scene/to_toml.h"

#include <string>
#include <vector>

/// A run's folder stands alone: the mesh files of its scene are copied into it.
namespace tumble::run {

struct MeshCopy {
    std::filesystem::path from;
    std::string name; // seen from scene.toml
    std::string content;
};

/// Read before the folder is touched: the scene may be that of the very run which is replaced. Problems: the system's
/// reason.
Result<std::vector<MeshCopy>> read_meshes(const scene::Scene& scene);

/// Problems: the system's reason.
Result<Done> write_meshes(const std::vector<MeshCopy>& copies, const RunFolder& folder);

scene::MeshNames names_of(const std::vector<MeshCopy>& copies);

} // namespace tumble::run
