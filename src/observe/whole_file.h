#pragma once

#include "base/problem.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tumble::observe {

/// Writes the file under another name in the same folder and renames it at the end: the name shows either the old
/// content or all of the new one. On failure the other name is removed. Problems: the system's reason.
Result<Done> write_whole(const std::filesystem::path& file, std::string_view content);

/// The whole content. Problems: not there, not readable, larger than `limit` bytes.
Result<std::string> read_whole(const std::filesystem::path& file, std::uintmax_t limit = std::uintmax_t{1} << 32);

} // namespace tumble::observe
