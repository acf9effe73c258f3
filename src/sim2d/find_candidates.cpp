#include "sim2d/step.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tumble::sim2d {

namespace {

/// Of the pairs found, in order, makes the near lists; what a pair remembers it keeps.
void list_near(const World& world, Chunk& chunk, std::span<const int> found) {
    thread_local std::vector<NearDiscs> old;
    thread_local std::vector<std::size_t> seen; // per material pair, how many of old
    old.resize(chunk.near_discs.size());
    std::swap(old, chunk.near_discs);
    seen.assign(old.size(), 0);
    for (NearDiscs& near : chunk.near_discs)
        near.clear();
    for (const int listed : found) {
        const DiscPair& pair = chunk.pairs[static_cast<std::size_t>(listed)];
        const auto kind = static_cast<std::size_t>(pair.kind);
        const NearDiscs& before = old[kind];
        std::size_t& k = seen[kind];
        while (k < before.pairs.size() && before.pairs[k].listed < listed)
            ++k;
        const bool known = k < before.pairs.size() && before.pairs[k].listed == listed;
        const FurtherMemory nothing{};
        chunk.near_discs[kind].add({pair.a, pair.b, pair.image, listed}, known ? before.touching[k] : std::uint8_t{0},
                                   known ? before.memory[k] : Memory{},
                                   !world.remembers_more ? nullptr
                                   : known               ? &before.further[k]
                                                         : &nothing);
    }
}

void find_near_discs(const World& world, Chunk& chunk) {
    chunk.found.resize(chunk.pairs.size() + 1);
    // What touched a step ago must stay listed until it is seen apart, however fast it left.
    const double skin = std::max(world.near_skin, world.last_rush);
    const int count =
        world.kernels->near_discs(world.rows.data(), chunk.pairs.data(), static_cast<int>(chunk.pairs.size()),
                                  world.images.data(), skin, chunk.found.data());
    list_near(world, chunk, {chunk.found.data(), static_cast<std::size_t>(count)});
    chunk.near_until = world.rush + skin;
}

/// Looks how far the disc is from the wall: it need not be asked again before both odometers have advanced that far.
void look(const World& world, const Chunk& chunk, WallNear& near, double travelled) {
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const Row& row = world.row(near.row);
    const Eigen::Vector2d centre = wall.frame.to_wall({row.x, row.y});
    double gap = std::numeric_limits<double>::infinity();
    for (int k = near.pieces_begin; k < near.pieces_begin + near.pieces_count; ++k)
        gap = std::min(gap, wall.line.distance(chunk.wall_pieces[static_cast<std::size_t>(k)], centre) - row.radius);
    near.awake = gap < world.near_skin || near.touches > 0;
    near.expires = travelled + (near.awake ? world.near_skin : gap);
}

} // namespace

void find_candidates(World& world, Chunk& chunk) {
    if (world.rush >= chunk.near_until && !chunk.pairs.empty())
        find_near_discs(world, chunk);
    for (WallNear& near : chunk.wall_nears) {
        const double travelled =
            world.travel[static_cast<std::size_t>(near.row)] + world.walls[static_cast<std::size_t>(near.wall)].travel;
        if (travelled >= near.expires)
            look(world, chunk, near, travelled);
    }
}

} // namespace tumble::sim2d
