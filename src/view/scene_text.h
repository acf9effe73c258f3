#pragma once

#include "base/problem.h"
#include "scene/load.h"
#include "scene/override.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::view {

/// A scene as it was written, so that it can be read again with other values: what the file becomes meanwhile does not
/// matter.
struct SceneText {
    std::string text;
    std::filesystem::path file;
    std::vector<scene::Override> sets;

    /// Problems: the file cannot be read.
    static Result<SceneText> read(const std::filesystem::path& file, std::vector<scene::Override> sets);

    /// With `more` on top. Problems: those of scene::load_scene_text.
    [[nodiscard]] Result<scene::Scene> load(const std::vector<scene::Override>& more = {}) const;
};

} // namespace tumble::view
