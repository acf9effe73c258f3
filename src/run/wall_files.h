#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::run {

struct WallFile {
    std::filesystem::path file;
    std::size_t triangles = 0;
};

/// Writes the named walls of a scene (all where none is named) as NAME.stl into the folder, where they stand at `time`
/// (s). Problems: a scene of two dimensions, a wall that it does not have, a file that is there already (unless
/// `overwrite`) or cannot be written.
Result<std::vector<WallFile>> write_wall_files(const scene::Scene& scene, const std::vector<std::string>& names,
                                               double time, const std::filesystem::path& folder, bool overwrite);

} // namespace tumble::run
