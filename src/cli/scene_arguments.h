#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace tumble::cli {

/// SCENE and what changes it. Members are filled when the command line is read.
struct SceneArguments {
    std::filesystem::path file;
    std::vector<std::string> sets;

    /// SCENE, --set, --duration.
    void add_to(CLI::App& command);
    /// Only --set, for commands that name their scene otherwise.
    void add_sets_to(CLI::App& command);

    [[nodiscard]] Result<scene::Scene> load() const;
};

/// TOML text of a word given on the command line: "top" -> "\"top\"".
std::string quoted(const std::string& word);

} // namespace tumble::cli
