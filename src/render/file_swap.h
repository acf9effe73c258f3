#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace tumble::render {

/// The name under which a file grows until it is whole: the same with ".part" behind it.
std::filesystem::path unfinished(const std::filesystem::path& file);

/// What the system said (errno) about a file, and the remedy.
Problem file_problem(const std::filesystem::path& file, const char* verb, int error);

/// Gives a whole unfinished file its name, replacing what had it.
Result<Done> finish_file(const std::filesystem::path& file);

/// Writes a file as a whole or not at all.
Result<Done> write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

} // namespace tumble::render
