#include "sim2d/kept_memory.h"

#include "sim2d/world.h"

#include <algorithm>

namespace tumble::sim2d {

void KeptMemory::take(const World& world) {
    const auto keep_further = [&](const std::vector<FurtherMemory>& all, std::size_t at) {
        if (!world.remembers_more)
            return -1;
        further_.push_back(all[at]);
        return static_cast<int>(further_.size()) - 1;
    };
    further_.clear();
    pairs_.begin_anew();
    walls_.begin_anew();
    for (const Chunk& chunk : world.chunks) {
        for (const NearDiscs& near : chunk.near_discs)
            for (std::size_t k = 0; k < near.pairs.size(); ++k)
                if (near.touching[k] != 0) {
                    const int a = world.tag_of(near.pairs[k].a), b = world.tag_of(near.pairs[k].b);
                    pairs_.add({std::min(a, b), std::max(a, b), keep_further(near.further, k), near.memory[k]});
                }
        for (std::size_t k = 0; k < chunk.wall_nears.size(); ++k) {
            const WallNear& near = chunk.wall_nears[k];
            for (std::size_t t = 0; t < static_cast<std::size_t>(near.touches); ++t)
                walls_.add({world.tag_of(near.row), near.wall,
                            keep_further(chunk.wall_further, max_wall_touches * k + t), near.memory[t]});
        }
    }
    const auto tags = static_cast<std::size_t>(world.tags);
    pairs_.group(tags, [](const KeptPair& kept) { return kept.first; });
    walls_.group(tags, [](const KeptWall& kept) { return kept.disc; });
}

void KeptMemory::forget() {
    pairs_.forget();
    walls_.forget();
    further_.clear();
}

bool KeptMemory::sound() const {
    const auto known = [&](const auto& kept) { return kept.further < static_cast<int>(further_.size()); };
    return pairs_.sound(known) && walls_.sound(known);
}

const KeptPair* KeptMemory::of_pair(int a, int b) const {
    const auto [first, second] = std::minmax(a, b);
    for (const KeptPair& old : pairs_.of(static_cast<std::size_t>(first)))
        if (old.second == second)
            return &old;
    return nullptr;
}

std::span<const KeptWall> KeptMemory::of_wall(int disc) const {
    return walls_.of(static_cast<std::size_t>(disc));
}

} // namespace tumble::sim2d
