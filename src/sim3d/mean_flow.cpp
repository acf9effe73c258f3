#include "sim3d/mean_flow.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace tumble::sim3d {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// With fewer bodies a gradient says little.
constexpr int fewest_for_gradient = 16;

/// Velocity gradient by least squares; along periodic directions the field must not change, or it would jump at the
/// end of the period.
Matrix3d gradient_of(const World& world, const MeanFlow& flow) {
    Matrix3d spread = Matrix3d::Zero();
    Matrix3d together = Matrix3d::Zero();
    for (const BodyMotion& body : world.motion) {
        Vector3d x = Vector3d(body.position) - flow.centre;
        for (int k = 0; k < 3; ++k)
            if (world.scene.domain.periodic[static_cast<std::size_t>(k)])
                x[k] = 0;
        spread += x * x.transpose();
        together += (Vector3d(body.velocity) - flow.velocity) * x.transpose();
    }
    // Directions in which the bodies are not spread get no gradient, instead of one divided by nothing.
    spread.diagonal().array() += 1e-6 * spread.trace() + 1e-30;
    return spread.ldlt().solve(together.transpose()).transpose();
}

Vector3d corner(const scene::Box& box, int k) {
    return {(k & 1) != 0 ? box.hi.x() : box.lo.x(), (k & 2) != 0 ? box.hi.y() : box.lo.y(),
            (k & 4) != 0 ? box.hi.z() : box.lo.z()};
}

} // namespace

MeanFlow fit_mean_flow(const World& world) {
    MeanFlow flow;
    if (world.bodies() == 0)
        return flow;
    Vector3d lo = Vector3d(world.motion.front().position);
    Vector3d hi = lo;
    for (const BodyMotion& body : world.motion) {
        const Vector3d position(body.position);
        flow.centre += position;
        flow.velocity += Vector3d(body.velocity);
        lo = lo.cwiseMin(position);
        hi = hi.cwiseMax(position);
    }
    flow.centre /= world.bodies();
    flow.velocity /= world.bodies();
    if (world.bodies() >= fewest_for_gradient)
        flow.gradient = gradient_of(world, flow);
    // Where a body may get to, sphere and all, before the next fit; bodies at rest may begin to move.
    flow.spare = 0.25 * world.reach + steps_per_fit * world.books.speed_max * world.dt;
    const double margin = 0.5 * world.reach + flow.spare;
    flow.box = {lo.array() - margin, hi.array() + margin};
    return flow;
}

double way_beside(const MeanFlow& flow, const scene::WallPose& from, const scene::WallPose& to, double dt) {
    double way = 0;
    for (int k = 0; k < 8; ++k) {
        const Vector3d point = corner(flow.box, k);
        const Vector3d moved = to.rotation * (from.rotation.transpose() * (point - from.translation)) + to.translation;
        way = std::max(way, (moved - point - flow.at(point) * dt).norm());
    }
    return way;
}

double way_past_rest(const MeanFlow& flow, double dt) {
    if (flow.gradient.isZero(0))
        return (flow.velocity * dt).norm();
    double way = 0;
    for (int k = 0; k < 8; ++k)
        way = std::max(way, (flow.at(corner(flow.box, k)) * dt).norm());
    return way;
}

} // namespace tumble::sim3d
