#pragma once

#include "base/problem.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace tumble::scene {

/// All bytes of a file of at most `cap` bytes. Problems (file only, no line): missing, a folder, unreadable, too large.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t cap);

/// "512 bytes", "1.5 KiB", "16 MiB": for sentences about sizes.
std::string in_words(std::size_t bytes);

} // namespace tumble::scene
