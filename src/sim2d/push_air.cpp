#include "sim2d/step.h"

namespace tumble::sim2d {

using Eigen::Vector2d;

void push_air(World& world, Chunk& chunk) {
    chunk.sums.lost_air_drag = 0;
    if (world.drag.empty())
        return;
    for (int slot = chunk.owned.body_begin; slot < chunk.owned.body_end; ++slot) {
        const contact::AirDrag& drag =
            world.drag[static_cast<std::size_t>(world.shape[static_cast<std::size_t>(slot)])];
        const Row& row = world.row(slot);
        // Of the velocity at the step, half a kick of weight and drag later: stable however strong the drag.
        const double half = (row.kick - 0.5) * world.dt;
        const Vector2d falling = Vector2d(row.vx, row.vy) + half * world.scene.gravity.head<2>();
        const double per_speed = drag.linear + drag.quadratic * falling.norm();
        const Vector2d now = falling / (1 + 0.5 * world.dt * per_speed / row.mass);
        const Vector2d force = -per_speed * now;
        Load& load = world.loads[static_cast<std::size_t>(slot)];
        load.fx += force.x();
        load.fy += force.y();
        // By the trapezoidal rule a body's first instant counts half.
        chunk.sums.lost_air_drag -= row.kick * world.dt * force.dot(now);
    }
}

} // namespace tumble::sim2d
