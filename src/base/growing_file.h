#pragma once

#include "base/problem.h"

#include <filesystem>

namespace tumble {

/// The name under which a file grows until it is whole: the same with ".part" behind it.
std::filesystem::path growing_name(const std::filesystem::path& file);

/// What the system said (errno) about a file that could not be, say, "write the file", and the remedy.
Problem file_problem(const std::filesystem::path& file, const char* verb, int error);

/// Whether a file can be made there, or made anew; nothing is left of the trial. Problems: there is no such folder, a
/// folder has that name, it may not be written.
Result<Done> check_writable(const std::filesystem::path& file);

} // namespace tumble
