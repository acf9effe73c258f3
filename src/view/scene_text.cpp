#include "view/scene_text.h"

#include "base/text.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

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

/// Whether a key changes nothing that bodies feel.
static bool is_look(const std::string& key) {
    return key.starts_with("render.") || key == "title" || key == "claim";
}

std::optional<std::string> SceneText::claim_with(const std::vector<scene::Override>& more) const {
    std::vector<std::pair<std::string, std::string>> set; // key and value, the last of each key
    for (const std::vector<scene::Override>* some : {&sets, &more})
        for (const scene::Override& one : *some) {
            const std::size_t equals = std::min(one.text.find('='), one.text.size() - 1);
            const std::string key(trimmed(one.text.substr(0, equals)));
            std::erase_if(set, [&](const auto& before) { return before.first == key; });
            if (!is_look(key))
                set.emplace_back(key, trimmed(one.text.substr(equals + 1)));
        }
    if (set.empty())
        return std::nullopt;
    std::string words;
    for (const auto& [key, value] : set)
        words += (words.empty() ? "" : ", ") + key + " = " + value;
    return fmt::format("none yet: {} with {}", file.generic_string(), words);
}

} // namespace tumble::view
