#include "sim2d/mean_flow.h"

#include <Eigen/LU>
#include <algorithm>

namespace tumble::sim2d {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// With fewer bodies a gradient says little.
constexpr int fewest_for_gradient = 16;

/// Velocity gradient by least squares; along periodic directions the field must not change, or it would jump at the
/// end of the period.
Matrix2d gradient_of(const World& world, const MeanFlow& flow) {
    Matrix2d spread = Matrix2d::Zero();
    Matrix2d together = Matrix2d::Zero();
    for (int slot = 0; slot < world.bodies(); ++slot) {
        const Row& body = world.row(slot);
        Vector2d x = Vector2d(body.x, body.y) - flow.centre;
        for (int k = 0; k < 2; ++k)
            if (world.scene.domain.periodic[static_cast<std::size_t>(k)])
                x[k] = 0;
        spread += x * x.transpose();
        together += (Vector2d(body.vx, body.vy) - flow.velocity) * x.transpose();
    }
    // Directions in which the bodies are not spread get no gradient, instead of one divided by nothing.
    spread.diagonal().array() += 1e-6 * spread.trace() + 1e-30;
    return together * spread.inverse();
}

Vector2d corner(const MeanFlow& flow, int k) {
    return {(k & 1) != 0 ? flow.hi.x() : flow.lo.x(), (k & 2) != 0 ? flow.hi.y() : flow.lo.y()};
}

} // namespace

MeanFlow fit_mean_flow(const World& world) {
    MeanFlow flow;
    if (world.bodies() == 0)
        return flow;
    flow.lo = flow.hi = Vector2d(world.rows.front().x, world.rows.front().y);
    double reach = 0;
    for (int slot = 0; slot < world.bodies(); ++slot) {
        const Row& body = world.row(slot);
        const Vector2d position(body.x, body.y);
        flow.centre += position;
        flow.velocity += Vector2d(body.vx, body.vy);
        flow.lo = flow.lo.cwiseMin(position);
        flow.hi = flow.hi.cwiseMax(position);
        reach = std::max(reach, world.shape_at(slot).reach);
    }
    flow.centre /= world.bodies();
    flow.velocity /= world.bodies();
    if (world.bodies() >= fewest_for_gradient)
        flow.gradient = gradient_of(world, flow);
    // Where a disc may get to before the next fit.
    const double margin =
        reach + world.skin + steps_per_fit * world.dt * (world.books.speed_max + reach * world.books.angular_speed_max);
    flow.lo.array() -= margin;
    flow.hi.array() += margin;
    return flow;
}

double way_beside(const MeanFlow& flow, const WallFrame& from, const WallFrame& to, double dt) {
    double way = 0;
    for (int k = 0; k < 4; ++k) {
        const Vector2d point = corner(flow, k);
        way = std::max(way, (to.to_world(from.to_wall(point)) - point - flow.at(point) * dt).norm());
    }
    return way;
}

double way_past_rest(const MeanFlow& flow, double dt) {
    if (flow.gradient.isZero(0))
        return (flow.velocity * dt).norm();
    double way = 0;
    for (int k = 0; k < 4; ++k)
        way = std::max(way, (flow.at(corner(flow, k)) * dt).norm());
    return way;
}

} // namespace tumble::sim2d
