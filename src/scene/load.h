#pragma once

#include "base/problem.h"
#include "scene/override.h"
#include "scene/scene.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// Reads a scene file and every file it names, after putting the `sets` in. Problems are complete: all that is wrong
/// with the file, each with its place ("--set KEY" for what a set brought), what is wrong and what to do. A set that
/// changes render.color takes the file's render.range away with it, which was meant for the other quantity.
Result<Scene> load_scene(const std::filesystem::path& file, const std::vector<Override>& sets = {});

/// The same of text; relative file names start at the folder of `file`, which need not exist.
Result<Scene> load_scene_text(std::string_view toml, const std::filesystem::path& file,
                              const std::vector<Override>& sets = {});

} // namespace tumble::scene
