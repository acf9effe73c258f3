#include "sim3d/step.h"

namespace tumble::sim3d {

void push_gravity(World& world, Chunk& chunk) {
    const Eigen::Vector3d g = world.scene.gravity;
    for (auto slot = static_cast<std::size_t>(chunk.begin); slot < static_cast<std::size_t>(chunk.end); ++slot) {
        const double mass = world.motion[slot].mass;
        world.load[slot] = {{mass * g.x(), mass * g.y(), mass * g.z(), 0}, {0, 0, 0, 0}};
    }
}

} // namespace tumble::sim3d
