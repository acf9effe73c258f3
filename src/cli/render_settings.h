#pragma once

#include "base/problem.h"
#include "cli/scene_arguments.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace tumble::cli {

/// Adds --camera, --color and the like. Each is another way to write a key of [render]: what was given is appended to
/// the sets as "render.KEY=VALUE" and gets that key's checks, whose problems name the flag.
void add_render_settings(CLI::App& command, SceneArguments& arguments);

/// A --set of a key that cannot change any more once a run is over: all but how it is drawn, its title and how its
/// walls are seen through. `scene` is the run's, for the advice.
Problems refuse_sets_of_the_run(const std::vector<std::string>& sets, const std::filesystem::path& scene);

} // namespace tumble::cli
