#pragma once

#include "sim3d/world.h"

#include <atomic>
#include <chrono>

namespace tumble::sim3d {

/// Adds the wall time from its making to its end to one phase of an account.
class Stopwatch {
public:
    Stopwatch(PhaseSeconds& seconds, Phase phase) : seconds_(seconds[static_cast<std::size_t>(phase)]) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Runs one verb of the step on the whole world, or on one chunk, and accounts for its time.
inline void timed(Phase phase, void (*verb)(World&), World& world) {
    const Stopwatch watch(world.seconds, phase);
    verb(world);
}
inline void timed(Phase phase, void (*verb)(World&, Chunk&), World& world, Chunk& chunk) {
    const Stopwatch watch(chunk.seconds, phase);
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
    const std::size_t count = world.chunks.size();
    std::atomic<ChunkSet> done{0};
    std::atomic<ChunkSet> taken{0};
    world.crew.share(static_cast<int>(count), [&](int k) {
        first(world.chunks[static_cast<std::size_t>(k)]);
        const ChunkSet ready = done.fetch_or(chunk_bit(k)) | chunk_bit(k);
        for (std::size_t c = 0; c < count; ++c) {
            const ChunkSet bit = chunk_bit(static_cast<int>(c));
            if (((bit | world.chunks[c].partners_before) & ~ready) == 0 && (taken.fetch_or(bit) & bit) == 0)
                then(world.chunks[c]);
        }
    });
}

} // namespace tumble::sim3d
