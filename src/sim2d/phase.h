#pragma once

#include "base/phases.h"
#include "sim2d/world.h"

namespace tumble::sim2d {

/// Runs one verb of the step on the whole world, or on one chunk, and accounts for its time.
inline void timed(Phase phase, void (*verb)(World&), World& world) {
    const Stopwatch watch(world.seconds[static_cast<std::size_t>(phase)]);
    verb(world);
}
inline void timed(Phase phase, void (*verb)(World&, Chunk&), World& world, Chunk& chunk) {
    const Stopwatch watch(chunk.seconds[static_cast<std::size_t>(phase)]);
    verb(world, chunk);
}

/// Calls task(chunk) for every chunk, on all threads.
template <class Task> void for_chunks(World& world, Task&& task) {
    world.crew.share(static_cast<int>(world.chunks.size()),
                     [&](int k) { task(world.chunks[static_cast<std::size_t>(k)]); });
}

/// Calls first(chunk) for every chunk, and then(chunk) as soon as first is done for it and for all that read or push
/// its bodies (Chunk::partners_before), on all threads.
template <class First, class Then> void for_chunks(World& world, First&& first, Then&& then) {
    relay(world.crew, world.chunks, first, then);
}

} // namespace tumble::sim2d
