#include "view/scene_text.h"

#include "scene/read_file.h"
#include "scene/read_toml.h"

namespace tumble::view {

Result<SceneText> SceneText::read(const std::filesystem::path& file, std::vector<scene::Override> sets) {
    Result<std::string> text = scene::read_file(file, scene::largest_scene);
    if (!text)
        return text.problems();
    return SceneText{std::move(*text), file, std::move(sets)};
}

Result<scene::Scene> SceneText::load(const std::vector<scene::Override>& more) const {
    std::vector<scene::Override> all = sets;
    all.insert(all.end(), more.begin(), more.end());
    return scene::load_scene_text(text, file, all);
}

} // namespace tumble::view
