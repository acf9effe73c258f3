#pragma once

#include "base/problem.h"

#include <algorithm>
#include <string_view>

namespace tumble::diagnose {

/// Names of warnings that a decision heeds.
namespace warning_key {
inline constexpr const char* clipped = "clipped";
inline constexpr const char* condition = "condition";
inline constexpr const char* dead = "does not change";
inline constexpr const char* end_of_stretch = "end of the stretch";
inline constexpr const char* forgotten_set = "set";
inline constexpr const char* doubled = "doubled";
inline constexpr const char* far_off = "nuisance far off";
inline constexpr const char* jump = "time jumps";
inline constexpr const char* lowest_point = "lowest point";
inline constexpr const char* peak_speed = "peak speed";
inline constexpr const char* rate = "rate of time";
inline constexpr const char* scale = "scale";
inline constexpr const char* shifted = "time shifted";
inline constexpr const char* speed = "speed";
inline constexpr const char* starts = "start";
inline constexpr const char* stuck = "stuck";
inline constexpr const char* too_short = "time too short";
inline constexpr const char* turned = "sign turned";
inline constexpr const char* unit = "unit";
inline constexpr const char* velocity_against_way = "velocity against way";
inline constexpr const char* zero = "zero";
} // namespace warning_key

/// A slip of whoever made the file: the likeliest reason for a large misfit.
inline constexpr const char* slips[] = {warning_key::forgotten_set, warning_key::shifted,   warning_key::jump,
                                        warning_key::rate,          warning_key::too_short, warning_key::scale,
                                        warning_key::condition,     warning_key::turned,    warning_key::zero,
                                        warning_key::starts,        warning_key::unit};

/// The first warning of that name; null: there is none.
inline const Problem* warned_of(const Problems& warnings, std::string_view key) {
    const auto found =
        std::find_if(warnings.begin(), warnings.end(), [&](const Problem& warning) { return warning.key == key; });
    return found == warnings.end() ? nullptr : &*found;
}

/// The first warning of the first of these names that there is; null: of none.
template <std::size_t count>
const Problem* first_warned_of(const Problems& warnings, const char* const (&keys)[count]) {
    for (const char* key : keys)
        if (const Problem* found = warned_of(warnings, key))
            return found;
    return nullptr;
}

} // namespace tumble::diagnose
