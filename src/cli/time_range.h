#pragma once

#include "base/problem.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tumble::cli {

/// "0.5:1.5", ":1.5", "0.5:" or nothing, in s; what is missing stays as it is. Problem: anything else; with
/// a run's folder it says from when to when there are frames.
std::optional<Problem> read_time_range(const std::string& text, double& from, double& to,
                                       const std::filesystem::path& run = {});

} // namespace tumble::cli
