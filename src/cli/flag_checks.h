#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// What the value of a flag must be, for CLI::Option::check; a refusal says it in the program's own words.
namespace tumble::cli {

CLI::Validator number_from(double lo, double hi);
CLI::Validator number_above_zero();
CLI::Validator whole_number_from(long long lo, long long hi);
CLI::Validator one_of(std::vector<std::string> words);

/// For flags that name what will be made: nothing is refused, and "-", which would become a file or folder of that
/// name.
std::string refuse_dash(const std::string& name);

} // namespace tumble::cli
