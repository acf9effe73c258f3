#include "sim3d/refresh.h"
#include "sim3d/step.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace tumble::sim3d {

namespace {

/// Of the pairs found, in order, makes the near lists; what a pair remembers it keeps.
void list_near(const World& world, Chunk& chunk, std::span<const int> found) {
    thread_local std::vector<NearSpheres> old;
    thread_local std::vector<std::size_t> seen; // per material pair, how many of old
    old.resize(chunk.near_spheres.size());
    std::swap(old, chunk.near_spheres);
    seen.assign(old.size(), 0);
    for (NearSpheres& near : chunk.near_spheres)
        near.clear();
    for (const int listed : found) {
        const SpherePair& pair = chunk.sphere_pairs[static_cast<std::size_t>(listed)];
        const auto kind = static_cast<std::size_t>(pair.kind);
        const NearSpheres& before = old[kind];
        std::size_t& k = seen[kind];
        while (k < before.pairs.size() && before.pairs[k].listed < listed)
            ++k;
        const bool known = k < before.pairs.size() && before.pairs[k].listed == listed;
        const FurtherLanes nothing{};
        chunk.near_spheres[kind].add({pair.a, pair.b, pair.image, listed}, known ? before.touching[k] : std::uint8_t{0},
                                     known ? before.memory[k] : MemoryLanes{},
                                     !world.remembers_more ? nullptr
                                     : known               ? &before.further[k]
                                                           : &nothing);
    }
}

void find_near_spheres(const World& world, Chunk& chunk) {
    chunk.found.resize(chunk.sphere_pairs.size() + 8);
    // What touched a step ago must stay listed until it is seen apart, however fast it left.
    const double skin = std::max(world.near_skin, world.last_rush + world.hold);
    const int count = world.kernels->near_spheres(world.motion.data(), chunk.sphere_pairs.data(),
                                                  static_cast<int>(chunk.sphere_pairs.size()), world.images.data(),
                                                  skin, chunk.found.data());
    list_near(world, chunk, {chunk.found.data(), static_cast<std::size_t>(count)});
    chunk.near_until = world.rush + skin;
}

} // namespace

void find_candidates(World& world, Chunk& chunk) {
    if (world.rush >= chunk.near_until && !chunk.sphere_pairs.empty())
        find_near_spheres(world, chunk);
    const auto travelled = [&](int slot) { return world.travel[static_cast<std::size_t>(slot)]; };
    for (BodyPair& pair : chunk.body_pairs)
        if (travelled(pair.a) + travelled(pair.b) >= pair.expires)
            refresh(world, chunk, pair);
    for (BodyWall& near : chunk.body_walls)
        if (travelled(near.body) + world.walls[static_cast<std::size_t>(near.wall)].travel >= near.expires)
            refresh(world, chunk, near);
}

} // namespace tumble::sim3d
