#include "sim3d/refresh.h"
#include "sim3d/step.h"

namespace tumble::sim3d {

namespace {

void find_near_pairs(const World& world, Chunk& chunk) {
    const auto pairs = static_cast<int>(chunk.sphere_pairs.size());
    chunk.near_pairs.resize(chunk.sphere_pairs.size() + 1);
    const int count =
        world.kernels->near_spheres(world.motion.data(), chunk.sphere_pairs.data(), pairs, world.images.data(),
                                    world.near_skin, chunk.sphere_touching.data(), chunk.near_pairs.data());
    chunk.near_pairs.resize(static_cast<std::size_t>(count));
    chunk.near_until = world.rush + world.near_skin;
}

} // namespace

void find_candidates(World& world, Chunk& chunk) {
    if (world.rush >= chunk.near_until && !chunk.sphere_pairs.empty())
        find_near_pairs(world, chunk);
    const auto travelled = [&](int slot) { return world.travel[static_cast<std::size_t>(slot)]; };
    for (BodyPair& pair : chunk.body_pairs)
        if (travelled(pair.a) + travelled(pair.b) >= pair.expires)
            refresh(world, chunk, pair);
    for (BodyWall& near : chunk.body_walls)
        if (travelled(near.body) + world.walls[static_cast<std::size_t>(near.wall)].travel >= near.expires)
            refresh(world, chunk, near);
}

} // namespace tumble::sim3d
