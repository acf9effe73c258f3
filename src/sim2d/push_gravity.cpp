#include "sim2d/step.h"

namespace tumble::sim2d {

void push_gravity(World& world, Chunk& chunk) {
    const Eigen::Vector2d g = world.scene.gravity.head<2>();
    for (int slot = chunk.owned.body_begin; slot < chunk.owned.body_end; ++slot) {
        const double mass = world.row(slot).mass;
        world.loads[static_cast<std::size_t>(slot)] = {mass * g.x(), mass * g.y(), 0, 0};
    }
    for (int disc = chunk.owned.disc_begin; disc < chunk.owned.disc_end; ++disc)
        world.loads[static_cast<std::size_t>(disc)] = {0, 0, 0, 0};
}

} // namespace tumble::sim2d
