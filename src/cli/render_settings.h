#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tumble::cli {

/// Adds --camera, --color and the like. Each is another way to write a key of [render]: what was given is appended to
/// `sets` as "render.KEY=VALUE" and gets that key's checks.
void add_render_settings(CLI::App& command, std::vector<std::string>& sets);

} // namespace tumble::cli
