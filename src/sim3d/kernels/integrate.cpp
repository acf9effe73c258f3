#include "base/vec3.h"
#include "sim3d/kernels/isa.h"

namespace tumble::sim3d::TUMBLE_ISA {

namespace {

using Vec = Vec3<double>;

TUMBLE_INLINE Vec read(const double* from) {
    return {from[0], from[1], from[2]};
}

TUMBLE_INLINE void write(double* to, const Vec& v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

/// Turns q (w x y z) by the small rotation vector w dt: sine and cosine to fourth order in the half angle, length kept
/// by one Newton step towards 1.
TUMBLE_INLINE void turn_by(const double* q, const Vec& spin, double dt, double* turned) {
    const Vec h = spin * (0.5 * dt);
    const double s = dot(h, h);
    const double c = 1 - s * (0.5 - s / 24);
    const Vec v = h * (1 - s / 6);
    double w = c * q[0] - v.x * q[1] - v.y * q[2] - v.z * q[3];
    double x = c * q[1] + v.x * q[0] + v.y * q[3] - v.z * q[2];
    double y = c * q[2] + v.y * q[0] + v.z * q[1] - v.x * q[3];
    double z = c * q[3] + v.z * q[0] + v.x * q[2] - v.y * q[1];
    const double towards_one = 1.5 - 0.5 * (w * w + x * x + y * y + z * z);
    turned[0] = w * towards_one;
    turned[1] = x * towards_one;
    turned[2] = y * towards_one;
    turned[3] = z * towards_one;
}

TUMBLE_INLINE void matrix_of(const double* q, double* r) {
    const double w = q[0];
    const double x = q[1];
    const double y = q[2];
    const double z = q[3];
    r[0] = 1 - 2 * (y * y + z * z);
    r[1] = 2 * (x * y - w * z);
    r[2] = 2 * (x * z + w * y);
    r[3] = 2 * (x * y + w * z);
    r[4] = 1 - 2 * (x * x + z * z);
    r[5] = 2 * (y * z - w * x);
    r[6] = 2 * (x * z - w * y);
    r[7] = 2 * (y * z + w * x);
    r[8] = 1 - 2 * (x * x + y * y);
}

/// R I^-1 R^T L: spin of a body with principal inertia I, rotation R and angular momentum L.
TUMBLE_INLINE Vec spin_of(const double* r, const double* inertia, const Vec& momentum) {
    const double x = (r[0] * momentum.x + r[3] * momentum.y + r[6] * momentum.z) / inertia[0];
    const double y = (r[1] * momentum.x + r[4] * momentum.y + r[7] * momentum.z) / inertia[1];
    const double z = (r[2] * momentum.x + r[5] * momentum.y + r[8] * momentum.z) / inertia[2];
    return {r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z};
}

/// Returns the energy of rotation at the step.
TUMBLE_INLINE double turn_sphere(BodyMotion& motion, BodyTurn& turn, const Vec& torque, double inertia, double dt) {
    const Vec kick = torque * (dt / inertia);
    const Vec next = read(motion.spin) + kick * motion.kick;
    const Vec now = next - kick * 0.5;
    write(motion.spin, next);
    turn_by(turn.orientation, next, dt, turn.orientation);
    return 0.5 * inertia * dot(now, now);
}

/// Angular momentum is kicked in the world frame, which keeps it to rounding; the orientation follows by the midpoint
/// rule, with the spin that belongs to the momentum at the orientation of half a step later.
TUMBLE_INLINE double turn_clump(BodyMotion& motion, BodyTurn& turn, const Vec& torque, const double* inertia,
                                double dt) {
    const Vec next = read(turn.momentum) + torque * (dt * motion.kick);
    const Vec now = next - torque * (0.5 * dt);
    write(turn.momentum, next);
    const double energy = 0.5 * dot(now, spin_of(turn.rotation, inertia, now));
    double halfway[4];
    double rotation[9];
    turn_by(turn.orientation, spin_of(turn.rotation, inertia, next), 0.5 * dt, halfway);
    matrix_of(halfway, rotation);
    const Vec spin = spin_of(rotation, inertia, next);
    turn_by(turn.orientation, spin, dt, turn.orientation);
    matrix_of(turn.orientation, turn.rotation);
    write(motion.spin, spin);
    return energy;
}

} // namespace

IntegrateSums integrate(const IntegrateContext& context) {
    IntegrateSums sums{0, 0, 0, 0, 0, 0, true};
    const double dt = context.dt;
    const Vec gravity = read(context.gravity);
    for (int slot = context.begin; slot < context.end; ++slot) {
        BodyMotion& motion = context.motion[slot];
        const BodyLoad& load = context.load[slot];
        const ShapeConstants& shape = context.shapes[context.shape[slot]];

        const Vec kick = read(load.force) * (dt / motion.mass);
        const Vec position = read(motion.position);
        const Vec next = read(motion.velocity) + kick * motion.kick;
        const Vec now = next - kick * 0.5;
        write(motion.velocity, next);
        write(motion.position, position + next * dt);
        sums.kinetic_translation += 0.5 * motion.mass * dot(now, now);
        sums.gravity -= motion.mass * dot(gravity, position);

        BodyTurn& turn = context.turn[slot];
        const Vec torque = read(load.torque);
        sums.kinetic_rotation += shape.single ? turn_sphere(motion, turn, torque, shape.inertia[0], dt)
                                              : turn_clump(motion, turn, torque, shape.inertia, dt);

        motion.kick = 1;
        const Vec spin = read(motion.spin);
        const double speed_squared = dot(next, next);
        const double spin_squared = dot(spin, spin);
        double way = root(speed_squared);
        if (!shape.single)
            way += root(spin_squared) * shape.reach;
        context.travel[slot] += way * dt;
        sums.travel_max = larger(sums.travel_max, context.travel[slot]);
        sums.speed_squared_max = larger(sums.speed_squared_max, speed_squared);
        sums.spin_squared_max = larger(sums.spin_squared_max, spin_squared);
        sums.finite = sums.finite && speed_squared + spin_squared < 1e30;
    }
    return sums;
}

} // namespace tumble::sim3d::TUMBLE_ISA
