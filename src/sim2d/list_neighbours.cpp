#include "sim2d/mean_flow.h"
#include "sim2d/rebuild_lists.h"
#include "sim2d/step.h"
#include "solver/leashes.h"

namespace tumble::sim2d {

void move_walls(World& world) {
    const double past_rest = way_past_rest(world.flow, world.dt);
    for (WallState& wall : world.walls) {
        if (wall.wall.motion.at_rest()) {
            wall.travel += past_rest;
        } else {
            const WallFrame before = wall.frame;
            wall.frame = WallFrame(scene::pose_at(wall.wall.motion, world.time()));
            wall.half_frame = WallFrame(scene::pose_at(wall.wall.motion, world.time() - 0.5 * world.dt));
            wall.leap = way_beside(world.flow, before, wall.frame, 0); // beside what does not flow meanwhile
            wall.travel += way_beside(world.flow, before, wall.frame, world.dt);
        }
    }
}

void list_neighbours(World& world) {
    world.last_rush = solver::closest_rush(world);
    world.rush += world.last_rush;
    if (world.step % steps_per_fit == 0 || world.stale)
        world.flow = fit_mean_flow(world);
    if (world.stale || solver::worn(world))
        rebuild_lists(world);
}

} // namespace tumble::sim2d
