#pragma once

#include "base/problem.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What the value of a flag must be, for CLI::Option::check; a refusal says it in the program's own words.
namespace tumble::cli {

CLI::Validator number_from(double lo, double hi);
CLI::Validator number_above_zero();
CLI::Validator whole_number_from(long long lo, long long hi);
CLI::Validator one_of(std::vector<std::string> words);
/// Of a file's name, dots included.
CLI::Validator ends_in(std::vector<std::string> endings);

/// For flags that name what will be made: nothing is refused, and "-", which would become a file or folder of that
/// name.
std::string refuse_no_place(const std::string& name);

/// The first of the files to be written that is there already.
std::optional<Problem> refuse_to_overwrite(const std::vector<std::filesystem::path>& files);

} // namespace tumble::cli
