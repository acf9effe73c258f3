#include "sim2d/kept_memory.h"

#include "sim2d/world.h"

#include <algorithm>

namespace tumble::sim2d {

namespace {

// Counting sort by key, stable.
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

template <class Entry>
std::span<const Entry> of_key(const std::vector<Entry>& sorted, const std::vector<int>& begin, int key) {
    const auto k = static_cast<std::size_t>(key);
    if (k + 1 >= begin.size())
        return {}; // a disc that came after the taking
    return {sorted.data() + begin[k], static_cast<std::size_t>(begin[k + 1] - begin[k])};
}

} // namespace

void KeptMemory::take(const World& world) {
    const auto keep_further = [&](const std::vector<FurtherMemory>& all, std::size_t at) {
        if (!world.remembers_more)
            return -1;
        further_.push_back(all[at]);
        return static_cast<int>(further_.size()) - 1;
    };
    further_.clear();
    unsorted_pairs_.clear();
    unsorted_walls_.clear();
    for (const Chunk& chunk : world.chunks) {
        for (const NearDiscs& near : chunk.near_discs)
            for (std::size_t k = 0; k < near.pairs.size(); ++k)
                if (near.touching[k] != 0) {
                    const int a = world.tag_of(near.pairs[k].a), b = world.tag_of(near.pairs[k].b);
                    unsorted_pairs_.push_back(
                        {std::min(a, b), std::max(a, b), keep_further(near.further, k), near.memory[k]});
                }
        for (std::size_t k = 0; k < chunk.wall_nears.size(); ++k) {
            const WallNear& near = chunk.wall_nears[k];
            for (std::size_t t = 0; t < static_cast<std::size_t>(near.touches); ++t)
                unsorted_walls_.push_back({world.tag_of(near.row), near.wall,
                                           keep_further(chunk.wall_further, max_wall_touches * k + t), near.memory[t]});
        }
    }
    const auto tags = static_cast<std::size_t>(world.tags);
    group(unsorted_pairs_, pairs_, pairs_begin_, next_, tags, [](const KeptPair& kept) { return kept.first; });
    group(unsorted_walls_, walls_, walls_begin_, next_, tags, [](const KeptWall& kept) { return kept.disc; });
}

void KeptMemory::forget() {
    pairs_.clear();
    pairs_begin_.clear();
    walls_.clear();
    walls_begin_.clear();
    further_.clear();
}

bool KeptMemory::sound() const {
    const auto inside = [](const std::vector<int>& begin, std::size_t entries) {
        return begin.empty() || (begin.front() == 0 && std::is_sorted(begin.begin(), begin.end()) &&
                                 static_cast<std::size_t>(begin.back()) == entries);
    };
    const auto known = [&](const auto& kept) { return kept.further < static_cast<int>(further_.size()); };
    return inside(pairs_begin_, pairs_.size()) && inside(walls_begin_, walls_.size()) &&
           std::all_of(pairs_.begin(), pairs_.end(), known) && std::all_of(walls_.begin(), walls_.end(), known);
}

const KeptPair* KeptMemory::of_pair(int a, int b) const {
    const auto [first, second] = std::minmax(a, b);
    for (const KeptPair& old : of_key(pairs_, pairs_begin_, first))
        if (old.second == second)
            return &old;
    return nullptr;
}

std::span<const KeptWall> KeptMemory::of_wall(int disc) const {
    return of_key(walls_, walls_begin_, disc);
}

} // namespace tumble::sim2d
