#include "sim3d/body_list.h"
#include "sim3d/mean_flow.h"
#include "sim3d/step.h"

#include <algorithm>
#include <limits>

namespace tumble::sim3d {

namespace {

/// How far two bodies can have come closer in the last step, m.
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
    for (WallState& wall : world.walls) {
        const scene::WallPose before = wall.pose;
        if (!wall.wall.motion.at_rest()) {
            wall.pose = pose_of(wall, world.time());
            wall.half_pose = pose_of(wall, world.time() - 0.5 * world.dt);
            wall.leap = way_beside(world.flow, before, wall.pose, 0); // beside what does not flow meanwhile
        }
        wall.way = way_beside(world.flow, before, wall.pose, world.dt);
        wall.travel += wall.way;
    }
}

void list_neighbours(World& world) {
    world.last_rush = closest_rush(world);
    world.rush += world.last_rush;
    world.flow.spare -= world.books.speed_max * world.dt;
    if (world.step % steps_per_fit == 0 || world.flow.spare < 0 || world.stale)
        world.flow = fit_mean_flow(world);
    if (world.stale || worn(world))
        rebuild_body_list(world);
}

} // namespace tumble::sim3d
