#include "sim3d/refresh.h"
#include "sim3d/step.h"

namespace tumble::sim3d {

void find_candidates(World& world, Chunk& chunk) {
    const auto travelled = [&](int slot) { return world.travel[static_cast<std::size_t>(slot)]; };
    for (BodyPair& pair : chunk.body_pairs)
        if (travelled(pair.a) + travelled(pair.b) >= pair.expires)
            refresh(world, chunk, pair);
    for (BodyWall& near : chunk.body_walls)
        if (travelled(near.body) + wall_travel(world, world.walls[static_cast<std::size_t>(near.wall)]) >= near.expires)
            refresh(world, chunk, near);
}

} // namespace tumble::sim3d
