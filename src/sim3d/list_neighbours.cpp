#include "sim3d/mean_flow.h"
#include "sim3d/rebuild_lists.h"
#include "sim3d/step.h"
#include "solver/leashes.h"

namespace tumble::sim3d {

scene::WallPose pose_of(const WallState& wall, double time) {
    scene::WallPose pose = scene::pose_at(wall.wall.motion, time);
    if (wall.in_place) {
        pose.velocity = pose.velocity_at(Eigen::Vector3d::Zero());
        pose.translation.setZero();
        pose.rotation.setIdentity();
    }
    return pose;
}

void move_walls(World& world) {
    const double past_rest = way_past_rest(world.flow, world.dt);
    for (WallState& wall : world.walls) {
        wall.way = past_rest;
        if (!wall.wall.motion.at_rest()) {
            const scene::WallPose before = wall.pose;
            wall.pose = pose_of(wall, world.time());
            wall.half_pose = pose_of(wall, world.time() - 0.5 * world.dt);
            wall.leap = way_beside(world.flow, before, wall.pose, 0); // beside what does not flow meanwhile
            wall.way = way_beside(world.flow, before, wall.pose, world.dt);
        }
        wall.travel += wall.way;
    }
}

void list_neighbours(World& world) {
    world.last_rush = solver::closest_rush(world);
    world.rush += world.last_rush;
    world.flow.spare -= world.books.speed_max * world.dt;
    if (world.step % steps_per_fit == 0 || world.flow.spare < 0 || world.stale)
        world.flow = fit_mean_flow(world);
    if (world.stale || solver::worn(world))
        rebuild_lists(world);
}

} // namespace tumble::sim3d
