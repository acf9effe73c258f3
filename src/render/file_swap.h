#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace tumble::render {

/// Gives a whole unfinished file its name, replacing what had it.
Result<Done> finish_file(const std::filesystem::path& file);

/// Writes a file as a whole or not at all.
Result<Done> write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

} // namespace tumble::render
