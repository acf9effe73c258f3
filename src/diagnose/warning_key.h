#pragma once

#include "base/problem.h"

#include <algorithm>
#include <iterator>
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

/// Slips of records that a cause may explain after all.
inline constexpr const char* of_records[] = {warning_key::shifted, warning_key::jump, warning_key::condition,
                                             warning_key::turned,  warning_key::zero, warning_key::starts,
                                             warning_key::scale,   warning_key::rate, warning_key::too_short};

inline bool is_of_records(std::string_view key) {
    return std::find(std::begin(of_records), std::end(of_records), key) != std::end(of_records);
}

/// Slips that end a search at one fit of each cause. A rate is none: whatever pulls a body from rest looks like one.
inline constexpr const char* slips[] = {warning_key::forgotten_set, warning_key::shifted, warning_key::jump,
                                        warning_key::condition,     warning_key::turned,  warning_key::zero,
                                        warning_key::starts,        warning_key::scale,   warning_key::unit};

/// All slips, and what is told before the search for causes.
inline constexpr const char* slips_told[] = {warning_key::forgotten_set, warning_key::rate,      warning_key::shifted,
                                             warning_key::jump,          warning_key::too_short, warning_key::condition,
                                             warning_key::turned,        warning_key::zero,      warning_key::starts,
                                             warning_key::scale,         warning_key::unit};
inline constexpr const char* told_early[] = {
    warning_key::forgotten_set, warning_key::rate,      warning_key::shifted, warning_key::jump,
    warning_key::too_short,     warning_key::condition, warning_key::turned,  warning_key::zero,
    warning_key::starts,        warning_key::scale,     warning_key::unit,    warning_key::lowest_point};

/// The first warning of that name; null: there is none.
inline const Problem* warned_of(const Problems& warnings, std::string_view key) {
    const auto found =
        std::find_if(warnings.begin(), warnings.end(), [&](const Problem& warning) { return warning.key == key; });
    return found == warnings.end() ? nullptr : &*found;
}

/// The first warning of any of these names; null: of none.
template <std::size_t count> const Problem* earliest_of(const Problems& warnings, const char* const (&keys)[count]) {
    const auto found = std::find_if(warnings.begin(), warnings.end(), [&](const Problem& warning) {
        return std::find(std::begin(keys), std::end(keys), warning.key) != std::end(keys);
    });
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
