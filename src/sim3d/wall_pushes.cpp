#include "sim3d/world.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

/// Velocities are those of half a step before the push: it is taken out again.
Vector3d velocity_before(const World& world, const WallContact& contact) {
    const auto slot = static_cast<std::size_t>(contact.body);
    const BodyMotion& motion = world.motion[slot];
    return Vector3d(motion.velocity) - world.dt / motion.mass * Vector3d(world.load[slot].force) -
           Vector3d(contact.wall_velocity);
}

/// Of a sphere on a plane, as Hertz' law has it: a^2 = R delta.
double patch_radius(const WallContact& contact) {
    return std::sqrt(contact.radius * std::max(0.0, contact.overlap));
}

void add_pushes(const World& world, const Chunk& chunk, int wall, std::vector<WallPush>& pushes) {
    std::vector<bool> wanted(chunk.wall_candidates.size());
    bool any = false;
    for (const BodyWall& near : chunk.body_walls)
        for (int k = near.begin; near.wall == wall && k < near.begin + near.count; ++k)
            wanted[static_cast<std::size_t>(k)] = any = true;
    if (!any)
        return;
    const Eigen::Matrix3d to_wall = world.walls[static_cast<std::size_t>(wall)].pose.rotation.transpose();
    for (const std::vector<WallContact>& contacts : chunk.wall_contacts)
        for (const WallContact& contact : contacts)
            if (wanted[static_cast<std::size_t>(contact.candidate)])
                pushes.push_back({world.id[static_cast<std::size_t>(contact.body)], contact.triangle,
                                  Vector3d(contact.foot), to_wall * Vector3d(contact.normal),
                                  -(to_wall * Vector3d(contact.force)), to_wall * velocity_before(world, contact),
                                  patch_radius(contact)});
}

} // namespace

std::vector<WallPush> wall_pushes_of(const World& world, int wall) {
    std::vector<WallPush> pushes;
    for (const Chunk& chunk : world.chunks)
        add_pushes(world, chunk, wall, pushes);
    return pushes;
}

} // namespace tumble::sim3d
