#pragma once

#include "base/carried.h"

#include <string>

namespace tumble {

/// Seconds spent in one verb of a step, summed over threads.
struct PhaseTime {
    std::string name;
    double seconds = 0;
};

template <class Archive, As<PhaseTime> P> void carry(Archive& archive, P& phase) {
    auto& [name, seconds] = phase;
    archive(name, seconds);
}

} // namespace tumble
