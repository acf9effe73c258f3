#pragma once

#include "base/problem.h"
#include "scene/load.h"
#include "scene/override.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
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

    /// What the scene with `more` on top can claim: that of the file holds no longer where keys that bodies feel were
    /// set, and then it is said which. Nothing where none was.
    [[nodiscard]] std::optional<std::string> claim_with(const std::vector<scene::Override>& more) const;
};

} // namespace tumble::view
