#include "sim3d/refresh.h"
#include "sim3d/step.h"

#include <algorithm>

namespace tumble::sim3d {

namespace {

void find_near_spheres(const World& world, Chunk& chunk) {
    chunk.found.resize(chunk.sphere_pairs.size() + 8);
    // What touched a step ago must stay listed until it is seen apart, however fast it left.
    const double skin = std::max(world.near_skin, world.last_rush + world.longest_neck);
    const int count = world.kernels->near_spheres(world.motion.data(), chunk.sphere_pairs.data(),
                                                  static_cast<int>(chunk.sphere_pairs.size()), world.images.data(),
                                                  skin, chunk.found.data());
    solver::list_near(chunk.near_spheres, chunk.sphere_pairs, {chunk.found.data(), static_cast<std::size_t>(count)},
                      world.remembers_more);
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
