#pragma once

#include "base/carried.h"
#include "base/parallel_for.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

/// What solvers share of how a step is cut into verbs and chunks.
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

/// Adds the wall time from its making to its end to a number of seconds.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : seconds_(seconds) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

constexpr int most_chunks = 16;
using ChunkSet = std::uint64_t; // a bit per chunk
static_assert(most_chunks <= 64);
constexpr ChunkSet chunk_bit(int chunk) {
    return ChunkSet{1} << chunk;
}

/// Calls first(chunk) for every chunk, and then(chunk) as soon as first is done for it and for all that read or push
/// its bodies (chunk.partners_before), on all threads.
template <class Chunks, class First, class Then> void relay(Crew& crew, Chunks& chunks, First&& first, Then&& then) {
    const std::size_t count = chunks.size();
    std::atomic<ChunkSet> done{0};
    std::atomic<ChunkSet> taken{0};
    crew.share(static_cast<int>(count), [&](int k) {
        first(chunks[static_cast<std::size_t>(k)]);
        const ChunkSet ready = done.fetch_or(chunk_bit(k)) | chunk_bit(k);
        for (std::size_t c = 0; c < count; ++c) {
            const ChunkSet bit = chunk_bit(static_cast<int>(c));
            if (((bit | chunks[c].partners_before) & ~ready) == 0 && (taken.fetch_or(bit) & bit) == 0)
                then(chunks[c]);
        }
    });
}

/// Lets a kernel write forces for bodies of other chunks, letters, behind those that chunk.foreign holds already:
/// push() writes at most `letters` through the context.
template <class Chunk, class Context, class Push>
void push_with_letters(Chunk& chunk, Context& context, int letters, Push&& push) {
    const auto room = static_cast<std::size_t>(chunk.foreign_count + letters);
    if (chunk.foreign.size() < room)
        chunk.foreign.resize(2 * room);
    context.foreign = chunk.foreign.data();
    context.foreign_count = chunk.foreign_count;
    push();
    chunk.foreign_count = context.foreign_count;
}

/// Calls read(letter) for all that those chunks wrote that may push this chunk's bodies, in a fixed order.
template <class Chunks, class Chunk, class Read>
void read_letters(const Chunks& chunks, const Chunk& chunk, Read&& read) {
    for (std::size_t k = 0; k < chunks.size(); ++k)
        if ((chunk.partners_before & chunk_bit(static_cast<int>(k))) != 0)
            for (int letter = 0; letter < chunks[k].foreign_count; ++letter)
                read(chunks[k].foreign[static_cast<std::size_t>(letter)]);
}

} // namespace tumble
