#include "sim3d/body_list.h"
#include "sim3d/phase.h"
#include "sim3d/refresh.h"
#include "sim3d/step.h"

namespace tumble::sim3d {

namespace {

bool body_list_is_worn(const World& world) {
    if (world.stale)
        return true;
    double travelled = 0;
    for (const Chunk& chunk : world.chunks)
        travelled = std::max(travelled, chunk.sums.motion.travel_max);
    double wall_travelled = travelled;
    for (const WallState& wall : world.walls)
        wall_travelled = std::max(wall_travelled, wall_travel(world, wall));
    return travelled + wall_travelled >= world.skin;
}

void place_walls(World& world) {
    for (WallState& wall : world.walls)
        if (!wall.wall.motion.at_rest()) {
            const double time = static_cast<double>(world.step) * world.dt;
            wall.pose = scene::pose_at(wall.wall.motion, time);
            wall.half_pose = scene::pose_at(wall.wall.motion, time - 0.5 * world.dt);
        }
}

} // namespace

void find_candidates(World& world) {
    place_walls(world);
    if (body_list_is_worn(world))
        rebuild_body_list(world);
    for_chunks(world, [&](Chunk& chunk) {
        for (BodyPair& pair : chunk.body_pairs)
            if (world.travel[static_cast<std::size_t>(pair.a)] + world.travel[static_cast<std::size_t>(pair.b)] >=
                pair.expires)
                refresh(world, chunk, pair);
        for (BodyWall& near : chunk.body_walls)
            if (world.travel[static_cast<std::size_t>(near.body)] +
                    wall_travel(world, world.walls[static_cast<std::size_t>(near.wall)]) >=
                near.expires)
                refresh(world, chunk, near);
    });
}

} // namespace tumble::sim3d
