#include "cli/scene_arguments.h"

#include "run/run_folder.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <set>
#include <string_view>

namespace tumble::cli {

namespace {

Problem a_folder(const std::filesystem::path& folder) {
    if (!run::find_run(folder))
        return {.file = folder.string(),
                .what = "is a folder, not a scene file",
                .fix = "name a scene file, such as scenes/drop.toml; `tumble list scenes DIR` lists those of a folder"};
    return {.file = folder.string(),
            .what = "is the folder of a run, not a scene file",
            .fix = "its scene is " + (folder / "scene.toml").string()};
}

} // namespace

void SceneArguments::add_to(CLI::App& command) {
    command.add_option("SCENE", file, "Scene file (TOML)")->required();
    command
        .add_option_function<std::string>(
            "--duration", [this](const std::string& text) { sets.push_back("duration_s=" + text); },
            "Simulated time, s; the same as --set duration_s=S")
        ->type_name("S");
    add_sets_to(command);
}

void SceneArguments::add_sets_to(CLI::App& command) {
    command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [this](const std::vector<std::string>& texts) { sets.insert(sets.end(), texts.begin(), texts.end()); },
            "Any key of the scene, with the checks it has in the file; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
}

Result<scene::Scene> SceneArguments::load() const {
    if (std::error_code ignored; std::filesystem::is_directory(file, ignored))
        return a_folder(file);
    std::vector<scene::Override> overrides;
    for (const std::string& text : sets)
        overrides.push_back({text});
    auto scene = scene::load_scene(file, overrides);
    if (!scene)
        return of_flags(scene.problems());
    return scene;
}

Problems SceneArguments::of_flags(const Problems& problems) const {
    constexpr std::string_view set = "--set ";
    Problems told;
    std::set<std::string> named;
    for (Problem problem : problems) {
        const auto flag = problem.file.starts_with(set) ? flags.find(problem.file.substr(set.size())) : flags.end();
        if (flag == flags.end()) {
            told.push_back(std::move(problem));
            continue;
        }
        if (!named.insert(flag->second.typed).second)
            continue;
        const std::string key = fmt::format("'{}'", flag->first.substr(flag->first.rfind('.') + 1));
        if (const std::size_t at = problem.what.find(key); at != std::string::npos)
            problem.what.replace(at, key.size(), "its value");
        const bool flat = problem.what.find("belongs to scenes of dimension") != std::string::npos;
        problem.file = flag->second.typed;
        problem.fix = flat ? "leave it away" : fmt::format("{}; for example {}", problem.fix, flag->second.example);
        told.push_back(std::move(problem));
    }
    return told;
}

std::string quoted(const std::string& word) {
    std::string text = "\"";
    for (const char c : word) {
        if (c == '"' || c == '\\')
            text += '\\';
        text += c;
    }
    return text + "\"";
}

} // namespace tumble::cli
