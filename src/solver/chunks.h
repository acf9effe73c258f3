#pragma once

#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// A world's bodies are cut into chunks, contiguous ranges that do not depend on the number of threads. Whatever a
/// chunk does, it does in one fixed order; forces for bodies of other chunks it writes down as letters, which those
/// open in a fixed order.
namespace tumble::solver {

constexpr int most_chunks = 16;
constexpr int fewest_bodies_per_chunk = 48;

inline int chunks_for(int bodies) {
    return std::clamp(bodies / fewest_bodies_per_chunk, 1, most_chunks);
}
/// The bodies of chunk k, from the first to one past the last.
inline std::pair<int, int> range_of(int k, int chunks, int bodies) {
    const auto from = [&](int chunk) { return static_cast<int>(static_cast<std::int64_t>(bodies) * chunk / chunks); };
    return {from(k), from(k + 1)};
}

using ChunkSet = std::uint64_t; // a bit per chunk
static_assert(most_chunks <= 64);
constexpr ChunkSet chunk_bit(int chunk) {
    return ChunkSet{1} << chunk;
}

/// Of each chunk that knows partners_after finds partners_before.
template <class Chunks> void find_partners(Chunks& chunks) {
    for (std::size_t k = 0; k < chunks.size(); ++k)
        for (std::size_t before = 0; before < chunks.size(); ++before)
            if (before != k && (chunks[before].partners_after & chunk_bit(static_cast<int>(k))) != 0)
                chunks[k].partners_before |= chunk_bit(static_cast<int>(before));
}

/// Calls task(chunk) for every chunk, on all threads.
template <class World, class Task> void for_chunks(World& world, Task&& task) {
    world.crew.share(static_cast<int>(world.chunks.size()),
                     [&](int k) { task(world.chunks[static_cast<std::size_t>(k)]); });
}

/// Calls first(chunk) for every chunk, and then(chunk) as soon as first is done for it and for all that read or push
/// its bodies (chunk.partners_before), on all threads.
template <class World, class First, class Then> void for_chunks(World& world, First&& first, Then&& then) {
    auto& chunks = world.chunks;
    const std::size_t count = chunks.size();
    if (count == 1) { // nothing to wait for
        first(chunks[0]);
        then(chunks[0]);
        return;
    }
    std::atomic<ChunkSet> done{0};
    std::atomic<ChunkSet> taken{0};
    world.crew.share(static_cast<int>(count), [&](int k) {
        first(chunks[static_cast<std::size_t>(k)]);
        const ChunkSet ready = done.fetch_or(chunk_bit(k)) | chunk_bit(k);
        for (std::size_t c = 0; c < count; ++c) {
            const ChunkSet bit = chunk_bit(static_cast<int>(c));
            if (((bit | chunks[c].partners_before) & ~ready) == 0 && (taken.fetch_or(bit) & bit) == 0)
                then(chunks[c]);
        }
    });
}

/// Lets a kernel write letters behind those that chunk.foreign holds already: push() writes at most `letters` through
/// the context.
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

} // namespace tumble::solver
