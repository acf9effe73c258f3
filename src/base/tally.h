#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace tumble {

/// Hears how far long work has come: so many of so many, and what is counted ("bodies placed"). Called now and then, on
/// the thread that asked for the work; empty where nobody listens. What is computed never depends on it.
using Tally = std::function<void(std::string_view what, std::int64_t done, std::int64_t all)>;

inline void tell_tally(const Tally& tally, std::string_view what, std::int64_t done, std::int64_t all) {
    if (tally)
        tally(what, done, all);
}

} // namespace tumble
