#include "sim2d/step.h"

#include <cmath>

namespace tumble::sim2d {

void place_discs(const ShapeConstants& shape, const Row& body, double angle, Row* discs) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (int k = 0; k < shape.exposed_count; ++k) {
        const double* disc = shape.exposed + 3 * static_cast<std::ptrdiff_t>(k);
        const double arm_x = c * disc[0] - s * disc[1];
        const double arm_y = s * disc[0] + c * disc[1];
        discs[k] = {body.x + arm_x,
                    body.y + arm_y,
                    disc[2],
                    body.mass,
                    body.vx - body.spin * arm_y,
                    body.vy + body.spin * arm_x,
                    body.spin,
                    1};
    }
}

void integrate(World& world, Chunk& chunk) {
    IntegrateContext context{};
    context.rows = world.rows.data();
    context.loads = world.loads.data();
    context.angle = world.angle.data();
    context.travel = world.travel.data();
    context.shape = world.shape.data();
    context.first_disc = world.first_disc.data();
    context.shapes = world.shape_constants.data();
    context.begin = chunk.owned.body_begin;
    context.end = chunk.owned.body_end;
    context.dt = world.dt;
    context.damping = world.scene.contact.global_damping;
    Eigen::Map<Eigen::Vector2d>{context.gravity} = world.scene.gravity.head<2>();
    Eigen::Map<Eigen::Vector2d>{context.flow_velocity} = world.flow.at(Eigen::Vector2d::Zero());
    Eigen::Map<Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>{context.flow_gradient} = world.flow.gradient;
    // The Frobenius norm bounds how fast the flow can part two points per metre between them.
    context.strain_way = 0.5 * world.flow.gradient.norm() * world.reach * world.dt;
    chunk.sums.motion = world.kernels->integrate(context);
}

} // namespace tumble::sim2d
