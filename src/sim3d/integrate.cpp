#include "sim3d/step.h"

namespace tumble::sim3d {

void integrate(World& world, Chunk& chunk) {
    const Eigen::Vector3d g = world.scene.gravity;
    const IntegrateContext context{world.motion.data(),  world.load.data(),  world.turn.data(),
                                   world.travel.data(),  world.shape.data(), world.shape_constants.data(),
                                   chunk.begin,          chunk.end,          world.dt,
                                   {g.x(), g.y(), g.z()}};
    chunk.sums.motion = world.kernels->integrate(context);
}

} // namespace tumble::sim3d
