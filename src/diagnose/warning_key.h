#pragma once

#include "base/problem.h"

#include <algorithm>
#include <string_view>

namespace tumble::diagnose {

/// Names of warnings that a decision heeds.
namespace warning_key {
inline constexpr const char* clipped = "clipped";
inline constexpr const char* dead = "does not change";
inline constexpr const char* lowest_point = "lowest point";
inline constexpr const char* peak_speed = "peak speed";
inline constexpr const char* shifted = "time shifted";
inline constexpr const char* speed = "speed";
inline constexpr const char* unit = "unit";
inline constexpr const char* velocity_against_way = "velocity against way";
} // namespace warning_key

/// The first warning of that name; null: there is none.
inline const Problem* warned_of(const Problems& warnings, std::string_view key) {
    const auto found =
        std::find_if(warnings.begin(), warnings.end(), [&](const Problem& warning) { return warning.key == key; });
    return found == warnings.end() ? nullptr : &*found;
}

} // namespace tumble::diagnose
