#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tumble::cli {

/// SCENE and what changes it. Members are filled when the command line is read.
struct SceneArguments {
    std::filesystem::path file;
    std::vector<std::string> sets;

    /// A flag that stands for sets.
    struct Flag {
        std::string typed;   // "--size 1280*720"
        std::string example; // "--size 1920x1080"
    };
    std::map<std::string, Flag> flags{}; // by the keys that they set

    /// SCENE, --set, --duration.
    void add_to(CLI::App& command);
    /// Only --set, for commands that name their scene otherwise.
    void add_sets_to(CLI::App& command);

    [[nodiscard]] Result<scene::Scene> load() const;
    /// Problems of keys that flags have set as problems of the flags, each of which is named once.
    [[nodiscard]] Problems of_flags(const Problems& problems) const;
};

/// TOML text of a word given on the command line: "top" -> "\"top\"".
std::string quoted(const std::string& word);

} // namespace tumble::cli
