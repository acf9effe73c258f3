#pragma once

#include "base/problem.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string_view>

namespace tumble::diagnose {

/// Names of warnings that a decision heeds.
namespace warning_key {
inline constexpr const char* clipped = "clipped";
inline constexpr const char* condition = "condition";
inline constexpr const char* dead = "does not change";
inline constexpr const char* doubled = "doubled";
inline constexpr const char* end_of_stretch = "end of the stretch";
inline constexpr const char* far_off = "nuisance far off";
inline constexpr const char* forgotten_set = "set";
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

/// A slip of a record that a cause may explain after all.
inline bool is_of_record(std::string_view key) {
    constexpr const char* keys[] = {warning_key::shifted, warning_key::jump, warning_key::condition,
                                    warning_key::turned,  warning_key::zero, warning_key::starts,
                                    warning_key::scale,   warning_key::rate, warning_key::too_short};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

/// A slip of whoever made the files.
inline bool is_slip(std::string_view key) {
    return is_of_record(key) || key == warning_key::forgotten_set || key == warning_key::unit;
}

/// A slip that ends a search at one fit of each cause. A rate is none: whatever pulls a body from rest looks like one.
inline bool ends_search(std::string_view key) {
    return is_slip(key) && key != warning_key::rate && key != warning_key::too_short;
}

/// The first warning of such a name; null: there is none.
template <class Such> const Problem* first_of(const Problems& warnings, const Such& such) {
    const auto found =
        std::find_if(warnings.begin(), warnings.end(), [&](const Problem& warning) { return such(warning.key); });
    return found == warnings.end() ? nullptr : &*found;
}

/// The first warning of that name.
inline const Problem* warned_of(const Problems& warnings, std::string_view key) {
    return first_of(warnings, [&](std::string_view other) { return other == key; });
}

/// That of the first of these names of which there is one.
inline const Problem* first_warned_of(const Problems& warnings, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (const Problem* found = warned_of(warnings, key))
            return found;
    return nullptr;
}

} // namespace tumble::diagnose
