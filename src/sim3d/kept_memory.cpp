#include "sim3d/kept_memory.h"

#include "sim3d/world.h"

#include <algorithm>

namespace tumble::sim3d {

namespace {

// Counting sort by key, stable, so that the order inside a body is the order in which the contacts stood.
template <class Entry, class Key>
void group(const std::vector<Entry>& entries, std::vector<Entry>& sorted, std::vector<int>& begin,
           std::vector<int>& next, std::size_t keys, Key&& key) {
    begin.assign(keys + 1, 0);
    for (const Entry& entry : entries)
        ++begin[static_cast<std::size_t>(key(entry)) + 1];
    for (std::size_t k = 0; k < keys; ++k)
        begin[k + 1] += begin[k];
    next = begin;
    sorted.resize(entries.size());
    for (const Entry& entry : entries)
        sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(key(entry))]++)] = entry;
}

KeptPair canonical(std::int64_t a, std::int64_t b, int sphere_a, int sphere_b, int image, const MemoryLanes& memory) {
    if (a < b)
        return {a, b, sphere_a, sphere_b, image, -1, memory};
    return {b, a, sphere_b, sphere_a, mirrored(image), -1, mirrored(memory)};
}

/// The image of b seen from a, after both were moved back into the box.
int image_after(int image, int a, int b, const std::vector<std::array<int, 3>>& wraps) {
    if (wraps.empty())
        return image;
    const auto& of_a = wraps[static_cast<std::size_t>(a)];
    const auto& of_b = wraps[static_cast<std::size_t>(b)];
    return image + (of_b[0] - of_a[0]) + 3 * (of_b[1] - of_a[1]) + 9 * (of_b[2] - of_a[2]);
}

} // namespace

void KeptMemory::take(const World& world, const std::vector<std::array<int, 3>>& wraps) {
    const auto keep_further = [&](const FurtherLanes& further) {
        further_.push_back(further);
        return static_cast<int>(further_.size()) - 1;
    };
    const auto keep = [&](int a, int b, int sphere_a, int sphere_b, int image, const MemoryLanes& memory,
                          const FurtherLanes* further) {
        const auto id_a = world.id[static_cast<std::size_t>(a)], id_b = world.id[static_cast<std::size_t>(b)];
        unsorted_pairs_.push_back(canonical(id_a, id_b, sphere_a, sphere_b, image_after(image, a, b, wraps), memory));
        if (further)
            unsorted_pairs_.back().further = keep_further(id_a < id_b ? *further : mirrored(*further));
    };
    further_.clear();
    unsorted_pairs_.clear();
    unsorted_walls_.clear();
    for (const Chunk& chunk : world.chunks) {
        for (const NearSpheres& near : chunk.near_spheres)
            for (std::size_t k = 0; k < near.pairs.size(); ++k)
                if (near.touching[k] != 0)
                    keep(near.pairs[k].a, near.pairs[k].b, 0, 0, near.pairs[k].image, near.memory[k],
                         world.remembers_more ? &near.further[k] : nullptr);
        for (const BodyPair& pair : chunk.body_pairs)
            for (auto k = static_cast<std::size_t>(pair.begin); k < static_cast<std::size_t>(pair.begin + pair.count);
                 ++k)
                if (chunk.candidates.touching[k] != 0)
                    keep(pair.a, pair.b, chunk.candidates.spheres[k].a, chunk.candidates.spheres[k].b, pair.image,
                         chunk.candidates.memory[k], world.remembers_more ? &chunk.candidates.further[k] : nullptr);
        for (const BodyWall& near : chunk.body_walls)
            for (int k = near.begin; k < near.begin + near.count; ++k) {
                const WallCandidate& candidate = chunk.wall_candidates[static_cast<std::size_t>(k)];
                for (int t = 0; t < candidate.touches; ++t)
                    unsorted_walls_.push_back(
                        {world.id[static_cast<std::size_t>(near.body)], near.wall, candidate.sphere,
                         world.remembers_more
                             ? keep_further(chunk.wall_further[static_cast<std::size_t>(max_wall_touches * k + t)])
                             : -1,
                         candidate.memory[static_cast<std::size_t>(t)]});
            }
    }
    const std::size_t ids = world.slot_of.size();
    group(unsorted_pairs_, pairs_, pairs_begin_, next_, ids, [](const KeptPair& kept) { return kept.first; });
    group(unsorted_walls_, walls_, walls_begin_, next_, ids, [](const KeptWall& kept) { return kept.body; });
}

std::span<const KeptPair> KeptMemory::of_first(std::int64_t first) const {
    const auto k = static_cast<std::size_t>(first);
    return {pairs_.data() + pairs_begin_[k], static_cast<std::size_t>(pairs_begin_[k + 1] - pairs_begin_[k])};
}

std::span<const KeptWall> KeptMemory::of_wall(std::int64_t body) const {
    const auto k = static_cast<std::size_t>(body);
    return {walls_.data() + walls_begin_[k], static_cast<std::size_t>(walls_begin_[k + 1] - walls_begin_[k])};
}

} // namespace tumble::sim3d
