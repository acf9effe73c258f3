#pragma once

#include "sheet/canvas.h"
#include "sheet/parameter.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

/// What lessons and experiments have in common on the command line.
namespace tumble::cli {

/// " --friction 0.3" of the first parameter, for the example that help begins with; empty when there is none.
std::string example_of(const std::vector<sheet::Parameter>& parameters);

/// One flag per parameter; what is typed is added to `typed`, which must outlive the command line.
void add_parameters(CLI::App& command, const std::vector<sheet::Parameter>& parameters, sheet::Typed& typed);

/// Draws the figures as PNG and SVG and names them on stderr. Exit code.
int draw_and_note(const sheet::Sheet& sheet, const std::filesystem::path& folder, bool json,
                  const sheet::Canvas& canvas = {});

} // namespace tumble::cli
