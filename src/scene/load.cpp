#include "scene/load.h"

#include "scene/check_keys.h"
#include "scene/keys.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"
#include "scene/report.h"
#include "scene/resolve.h"
#include "scene/view.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace tumble::scene {
namespace {

void note(const std::string& path, const Place& place, Scene& scene) {
    scene.written[path] = {*place.source, place.line, place.column};
}

/// Paths as views and problems have them: members of lists by name or number.
void note_places(const Node& node, const std::string& path, const std::string& keys, Scene& scene) {
    const Table* table = node.as<Table>();
    if (!table)
        return;
    for (const Entry& entry : table->entries) {
        const std::string inner = path.empty() ? entry.name : path + "." + entry.name;
        const std::string inner_keys = keys.empty() ? entry.name : keys + "." + entry.name;
        const KeyTable* spec = find_table(inner_keys);
        const Array* list = entry.node.as<Array>();
        note(inner, entry.node.place, scene);
        note_places(entry.node, inner, spec ? inner_keys : keys, scene);
        for (std::size_t i = 0; spec && list && i < list->items.size(); ++i) {
            const std::string member = inner + "." + label_of(list->items[i], *spec, i);
            note(member, list->items[i].place, scene);
            note_places(list->items[i], member, inner_keys, scene);
        }
    }
}

Table* render_of(Node& root) {
    Table* top = root.as<Table>();
    Entry* render = top ? top->find("render") : nullptr;
    return render ? render->node.as<Table>() : nullptr;
}

/// What [render] says, or would say by default.
std::string word_of(Node& root, const char* key) {
    const Table* render = render_of(root);
    const Entry* entry = render ? render->find(key) : nullptr;
    const std::string* word = entry ? entry->node.as<std::string>() : nullptr;
    return word ? *word : std::get<std::string>(find_key(*find_table("render"), key)->standard);
}

bool all_from(const Node& node, const std::string& source) {
    const Array* list = node.as<Array>();
    const auto inside = [&](const Node& item) { return all_from(item, source); };
    return *node.place.source == source && (!list || std::all_of(list->items.begin(), list->items.end(), inside));
}

/// A range was chosen for the colour beside it: with another colour from a set it would mean something else.
void drop_range_of_another_color(Node& root, const std::string& color_of_file) {
    Table* render = render_of(root);
    if (render && word_of(root, "color") != color_of_file)
        std::erase_if(render->entries, [&](const Entry& entry) {
            return entry.name == "range" && all_from(entry.node, *root.place.source);
        });
}

/// What a style says of size and furniture goes with it: under another style from a set the file's would be in the way.
void drop_size_of_another_style(Node& root, const std::string& style_of_file) {
    constexpr std::array<std::string_view, 8> sizes{"width_px", "height_px", "background", "plot",
                                                    "width_mm", "height_mm", "dpi",        "font_pt"};
    Table* render = render_of(root);
    if (render && word_of(root, "style") != style_of_file)
        std::erase_if(render->entries, [&](const Entry& entry) {
            return std::find(sizes.begin(), sizes.end(), entry.name) != sizes.end() &&
                   all_from(entry.node, *root.place.source);
        });
}

} // namespace

Result<Scene> load_scene_text(std::string_view toml, const std::filesystem::path& file,
                              const std::vector<Override>& sets) {
    auto root = parse_toml(toml, file.string());
    if (!root)
        return root.problems();
    Report report;
    const std::string color = word_of(*root, "color"), style = word_of(*root, "style");
    for (const Override& set : sets)
        report.add(apply(set, *root));
    drop_range_of_another_color(*root, color);
    drop_size_of_another_style(*root, style);
    check_keys(*root, report);

    Scene scene;
    scene.file = file;
    note_places(*root, "", "", scene);
    const View top(&*root, *find_table(""), "", report);
    const Resolving to{file.parent_path(), report, scene};
    resolve_world(top, to);
    resolve_materials(top, to);
    resolve_bodies(top, to);
    resolve_fills(top, to);
    resolve_walls(top, to);
    resolve_output(top, to);
    resolve_box2d(top, to);
    check_pairs(top, to);
    if (report.clean())
        apply_reductions(top, to);
    if (!report.clean())
        return report.sorted(file.string());
    return scene;
}

Result<Scene> load_scene(const std::filesystem::path& file, const std::vector<Override>& sets) {
    const auto text = read_file(file, largest_scene);
    if (!text)
        return text.problems();
    return load_scene_text(*text, file, sets);
}

} // namespace tumble::scene
