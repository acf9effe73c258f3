#include "sim2d/mean_flow.h"
#include "sim2d/pair_list.h"
#include "sim2d/step.h"

#include <algorithm>
#include <limits>

namespace tumble::sim2d {

namespace {

/// How far two discs can have come closer in the last step, m.
double closest_rush(const World& world) {
    double way = 0;
    for (const Chunk& chunk : world.chunks)
        way = std::max(way, chunk.sums.motion.way_max);
    return 2 * way;
}

bool worn(const World& world) {
    double travelled = std::numeric_limits<double>::lowest();
    for (const Chunk& chunk : world.chunks)
        travelled = std::max(travelled, chunk.sums.motion.travel_max);
    double wall_travelled = 0;
    for (const WallState& wall : world.walls)
        wall_travelled = std::max(wall_travelled, wall.travel);
    return travelled >= 0 || wall_travelled >= world.wall_skin;
}

} // namespace

void move_walls(World& world) {
    for (WallState& wall : world.walls) {
        const WallFrame before = wall.frame;
        if (!wall.wall.motion.at_rest()) {
            wall.frame = WallFrame(scene::pose_at(wall.wall.motion, world.time()));
            wall.half_frame = WallFrame(scene::pose_at(wall.wall.motion, world.time() - 0.5 * world.dt));
            wall.leap = way_beside(world.flow, before, wall.frame, 0); // beside what does not flow meanwhile
        }
        wall.travel += way_beside(world.flow, before, wall.frame, world.dt);
    }
}

void list_neighbours(World& world) {
    world.last_rush = closest_rush(world);
    world.rush += world.last_rush;
    if (world.step % steps_per_fit == 0 || world.stale)
        world.flow = fit_mean_flow(world);
    if (world.stale || worn(world))
        rebuild_lists(world);
}

} // namespace tumble::sim2d
