#include "observe/bulk.h"

#include <cmath>
#include <limits>

namespace tumble::observe {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double mass_of(const Frame& frame, std::size_t body) {
    return frame.layout->shapes[static_cast<std::size_t>(frame.shape[body])].mass;
}

double spin_energy(const Frame& frame, std::size_t body) {
    const FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[body])];
    const Eigen::Vector3d spin = frame.orientation[body].conjugate() * frame.angular_velocity[body];
    return 0.5 * shape.inertia.dot(spin.cwiseAbs2());
}

BulkMotion empty_bulk() {
    BulkMotion bulk;
    bulk.mass = 0;
    bulk.centre = bulk.velocity = bulk.rms_velocity = Eigen::Vector3d::Constant(nan);
    bulk.mean_speed = bulk.mean_angular_speed = bulk.circulation = nan;
    return bulk;
}

double circulation_about(const Frame& frame, const Eigen::Vector3d& centre, const Eigen::Vector3d& velocity) {
    // From the first of these axes to the second: y to z, and in two dimensions x to y.
    const bool flat = frame.layout->dimension == 2;
    const int one = flat ? 0 : 1, other = flat ? 1 : 2;
    if (frame.layout->periodic[static_cast<std::size_t>(one)] ||
        frame.layout->periodic[static_cast<std::size_t>(other)])
        return nan;
    double momentum = 0;
    double inertia = 0;
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const Eigen::Vector3d arm = frame.position[i] - centre;
        const Eigen::Vector3d flow = frame.velocity[i] - velocity;
        momentum += mass_of(frame, i) * (arm[one] * flow[other] - arm[other] * flow[one]);
        inertia += mass_of(frame, i) * (arm[one] * arm[one] + arm[other] * arm[other]);
    }
    return inertia > 0 ? momentum / inertia : nan;
}

} // namespace

BulkMotion bulk_motion(const Frame& frame) {
    if (frame.bodies() == 0)
        return empty_bulk();
    BulkMotion bulk;
    Eigen::Vector3d square = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const double mass = mass_of(frame, i);
        bulk.mass += mass;
        bulk.centre += mass * frame.position[i];
        bulk.velocity += mass * frame.velocity[i];
        square += mass * frame.velocity[i].cwiseAbs2();
        bulk.kinetic_rotation += spin_energy(frame, i);
        bulk.mean_speed += mass * frame.velocity[i].norm();
        bulk.mean_angular_speed += mass * frame.angular_velocity[i].norm();
    }
    bulk.kinetic_translation = 0.5 * square.sum();
    bulk.centre /= bulk.mass;
    bulk.velocity /= bulk.mass;
    bulk.rms_velocity = (square / bulk.mass).cwiseSqrt();
    bulk.mean_speed /= bulk.mass;
    bulk.mean_angular_speed /= bulk.mass;
    bulk.circulation = circulation_about(frame, bulk.centre, bulk.velocity);
    return bulk;
}

} // namespace tumble::observe
