#include "sim3d/step.h"

namespace tumble::sim3d {

using Eigen::Vector3d;

void push_air(World& world, Chunk& chunk) {
    chunk.sums.lost_air_drag = 0;
    if (world.drag.empty())
        return;
    for (auto slot = static_cast<std::size_t>(chunk.begin); slot < static_cast<std::size_t>(chunk.end); ++slot) {
        const contact::AirDrag& drag = world.drag[static_cast<std::size_t>(world.shape[slot])];
        const BodyMotion& motion = world.motion[slot];
        // Of the velocity at the step, half a kick of weight and drag later: stable however strong the drag.
        const double half = (motion.kick - 0.5) * world.dt;
        const Vector3d falling = Vector3d(motion.velocity) + half * world.scene.gravity;
        const double per_speed = drag.linear + drag.quadratic * falling.norm();
        const Vector3d now = falling / (1 + 0.5 * world.dt * per_speed / motion.mass);
        const Vector3d force = -per_speed * now;
        for (int axis = 0; axis < 3; ++axis)
            world.load[slot].force[axis] += force[axis];
        // By the trapezoidal rule a body's first instant counts half.
        chunk.sums.lost_air_drag -= motion.kick * world.dt * force.dot(now);
    }
}

} // namespace tumble::sim3d
