#include "reduce/kept_run.h"

#include "base/hash.h"
#include "observe/whole_file.h"
#include "run/build_mark.h"
#include "run/mesh_copies.h"
#include "run/scene_changes.h"
#include "scene/read_file.h"
#include "scene/to_toml.h"

#include <cctype>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tumble::reduce {

using Json = nlohmann::ordered_json;

Result<std::string> name_of_run(const std::string& rung, const scene::Scene& scene) {
    const auto meshes = run::read_meshes(scene);
    if (!meshes)
        return meshes.problems();
    Hash64 hash;
    hash.add(scene::to_toml(scene, run::names_of(*meshes))).add(run::build_mark());
    for (const run::MeshMark& mark : run::marks_of(*meshes))
        hash.add(mark.hash);
    std::string name;
    for (const char c : rung)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '.')
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    return fmt::format("{}-seed-{}-{}", name, scene.seed, hash.hex());
}

std::optional<KeptRun> read_kept(const std::filesystem::path& file) {
    const auto text = scene::read_file(file, std::uintmax_t{1} << 20);
    if (!text)
        return std::nullopt;
    const Json json = Json::parse(*text, nullptr, false);
    const auto holds = [&](const char* key, bool (Json::*is)() const noexcept) {
        return json.contains(key) && (json[key].*is)();
    };
    if (!json.is_object() || !holds("core_s", &Json::is_number) || !holds("overlap", &Json::is_number) ||
        !holds("failure", &Json::is_string) || !holds("doubts", &Json::is_array))
        return std::nullopt;
    KeptRun run{json["core_s"], json["overlap"], json["failure"], {}};
    for (const auto& doubt : json["doubts"])
        if (doubt.is_string())
            run.doubts.push_back(doubt);
    return run;
}

Result<Done> write_kept(const std::filesystem::path& file, const KeptRun& run) {
    const Json json{{"core_s", run.core_s}, {"overlap", run.overlap}, {"failure", run.failure}, {"doubts", run.doubts}};
    return observe::write_whole(file, json.dump(2) + "\n");
}

} // namespace tumble::reduce
