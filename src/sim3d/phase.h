#pragma once

#include "sim3d/world.h"

#include <chrono>

namespace tumble::sim3d {

/// Runs one verb of the step and adds its wall time to the world's account of that name.
inline void timed(World& world, const char* name, void (*verb)(World&)) {
    const auto start = std::chrono::steady_clock::now();
    verb(world);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (PhaseTime& phase : world.phases)
        if (phase.name == name) {
            phase.seconds += seconds;
            return;
        }
    world.phases.push_back({name, seconds});
}

/// Calls task(chunk) for every chunk, on all threads.
template <class Task> void for_chunks(World& world, Task&& task) {
    world.crew.share(static_cast<int>(world.chunks.size()),
                     [&](int k) { task(world.chunks[static_cast<std::size_t>(k)]); });
}

} // namespace tumble::sim3d
