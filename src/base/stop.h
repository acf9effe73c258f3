#pragma once

#include "base/problem.h"

#include <atomic>

namespace tumble {

/// Set from elsewhere, and then for good, when long work should end early; null where nobody asks for that. Whatever
/// keeps one is outlived by it.
using StopFlag = const std::atomic<bool>*;

inline bool stop_wanted(StopFlag stop) {
    return stop && stop->load(std::memory_order_relaxed);
}

/// What work answers that ended early before there was anything to show.
inline Problem stopped_before_it_began() {
    return {.what = "stopped while the scene was being built", .fix = "no step was taken and no file written"};
}

} // namespace tumble
