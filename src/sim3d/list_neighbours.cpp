#include "sim3d/body_list.h"
#include "sim3d/refresh.h"
#include "sim3d/step.h"

#include <algorithm>

namespace tumble::sim3d {

namespace {

bool worn(const World& world) {
    double travelled = 0;
    for (const Chunk& chunk : world.chunks)
        travelled = std::max(travelled, chunk.sums.motion.travel_max);
    double other_travelled = travelled;
    for (const WallState& wall : world.walls)
        other_travelled = std::max(other_travelled, wall_travel(world, wall));
    return travelled + other_travelled >= world.skin;
}

} // namespace

void move_walls(World& world) {
    for (WallState& wall : world.walls)
        if (!wall.wall.motion.at_rest()) {
            wall.pose = scene::pose_at(wall.wall.motion, world.time());
            wall.half_pose = scene::pose_at(wall.wall.motion, world.time() - 0.5 * world.dt);
        }
}

void list_neighbours(World& world) {
    if (world.stale || worn(world))
        rebuild_body_list(world);
}

} // namespace tumble::sim3d
