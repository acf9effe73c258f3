#include "sim3d/step.h"

namespace tumble::sim3d {

void integrate(World& world, Chunk& chunk) {
    const Eigen::Vector3d g = world.scene.gravity;
    IntegrateContext context{world.motion.data(),
                             world.load.data(),
                             world.orientation.data(),
                             world.turn.data(),
                             world.travel.data(),
                             world.shape.data(),
                             world.shape_constants.data(),
                             chunk.begin,
                             chunk.end,
                             world.dt,
                             {g.x(), g.y(), g.z()},
                             {},
                             {},
                             0,
                             world.scene.turn_spheres};
    Eigen::Map<Eigen::Vector3d>{context.flow_velocity} = world.flow.at(Eigen::Vector3d::Zero());
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{context.flow_gradient} = world.flow.gradient;
    // The Frobenius norm bounds how fast the flow can part two points per metre between them.
    context.strain_way = 0.5 * world.flow.gradient.norm() * world.reach * world.dt;
    chunk.sums.motion = world.kernels->integrate(context);
}

} // namespace tumble::sim3d
