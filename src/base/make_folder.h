#pragma once

#include "base/problem.h"

#include <filesystem>

namespace tumble {

/// Makes the folder and those above it that are missing; one that is there is fine. Problems: the system's reason.
Result<Done> make_folder(const std::filesystem::path& folder);

} // namespace tumble
