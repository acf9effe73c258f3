#pragma once

#include "base/problem.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tumble::observe {

/// How sure a written file is to be there after the machine lost its power: `hurried` leaves that to the system, which
/// writes within half a minute or so; `lasting` waits for the disk, for the file and for its name in the folder.
enum class Writing { hurried, lasting };

/// Writes the file under another name in the same folder and renames it at the end: the name shows either the old
/// content or all of the new one. On failure the other name is removed. Problems: the system's reason.
Result<Done> write_whole(const std::filesystem::path& file, std::string_view content,
                         Writing writing = Writing::hurried);

/// Waits until the disk has the content of a file, or the names in a folder. Problems: the system's reason.
Result<Done> wait_for_disk(const std::filesystem::path& place);

/// The whole content. Problems: not there, not readable, larger than `limit` bytes.
Result<std::string> read_whole(const std::filesystem::path& file, std::uintmax_t limit = std::uintmax_t{1} << 32);

} // namespace tumble::observe
