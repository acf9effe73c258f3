#include "scene/load.h"

#include "scene/check_keys.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"
#include "scene/report.h"
#include "scene/resolve.h"
#include "scene/view.h"

namespace tumble::scene {

Result<Scene> load_scene_text(std::string_view toml, const std::filesystem::path& file,
                              const std::vector<Override>& sets) {
    auto root = parse_toml(toml, file.string());
    if (!root)
        return root.problems();
    Report report;
    for (const Override& set : sets)
        report.add(apply(set, *root));
    check_keys(*root, report);

    Scene scene;
    scene.file = file;
    const View top(&*root, *find_table(""), "", report);
    const Resolving to{file.parent_path(), report, scene};
    resolve_world(top, to);
    resolve_materials(top, to);
    resolve_bodies(top, to);
    resolve_fills(top, to);
    resolve_walls(top, to);
    resolve_output(top, to);
    check_pairs(top, to);
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
