#pragma once

#include "base/problem.h"

#include <CLI/CLI.hpp>
#include <string>

namespace tumble::cli {

/// What the reader of the command line found wrong, in the words of the help. `command`: the innermost one chosen, and
/// the words that lead to it: "tumble lesson two-discs".
Problem usage_problem(const CLI::ParseError& error, const CLI::App& command, const std::string& words);

} // namespace tumble::cli
