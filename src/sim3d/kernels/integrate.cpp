#include "base/vec3.h"
#include "sim3d/kernels/isa.h"

namespace tumble::sim3d::TUMBLE_ISA {

namespace {

constexpr int lanes = Pack::lanes;

template <class Real> struct Quaternion { Real w, x, y, z; };

/// Turns q by the small rotation vector spin * dt: sine and cosine to fourth order in the half angle, length kept by
/// one Newton step towards 1.
template <class Real>
TUMBLE_INLINE Quaternion<Real> turned(const Quaternion<Real>& q, const Vec3<Real>& spin, Real dt) {
    const Vec3<Real> h = spin * (Real(0.5) * dt);
    const Real s = dot(h, h);
    const Real c = Real(1.0) - s * (Real(0.5) - s * Real(1.0 / 24));
    const Vec3<Real> v = h * (Real(1.0) - s * Real(1.0 / 6));
    const Quaternion<Real> r{c * q.w - v.x * q.x - v.y * q.y - v.z * q.z, c * q.x + v.x * q.w + v.y * q.z - v.z * q.y,
                             c * q.y + v.y * q.w + v.z * q.x - v.x * q.z, c * q.z + v.z * q.w + v.x * q.y - v.y * q.x};
    const Real towards_one = Real(1.5) - Real(0.5) * (r.w * r.w + r.x * r.x + r.y * r.y + r.z * r.z);
    return {r.w * towards_one, r.x * towards_one, r.y * towards_one, r.z * towards_one};
}

template <class Real> TUMBLE_INLINE Vec3<Real> spread(const double* v) {
    return {Real(v[0]), Real(v[1]), Real(v[2])};
}

template <class Real> TUMBLE_INLINE Vec3<Real> flow_at(const IntegrateContext& context, const Vec3<Real>& p) {
    const double* g = context.flow_gradient;
    return spread<Real>(context.flow_velocity) + Vec3<Real>{Real(g[0]) * p.x + Real(g[1]) * p.y + Real(g[2]) * p.z,
                                                            Real(g[3]) * p.x + Real(g[4]) * p.y + Real(g[5]) * p.z,
                                                            Real(g[6]) * p.x + Real(g[7]) * p.y + Real(g[8]) * p.z};
}

/// Sums and extremes of one body, or of eight in lanes.
template <class Real> struct Tally {
    Real translation{0.0}, rotation{0.0}, gravity{0.0}; // J, at the step
    Real speed_squared{0.0}, spin_squared{0.0};         // of the next half step
    Real travel{-1e300}, way{0.0};                      // m, the odometer and its advance

    TUMBLE_INLINE void add(const Tally& body) {
        translation = translation + body.translation;
        rotation = rotation + body.rotation;
        gravity = gravity + body.gravity;
        speed_squared = larger(speed_squared, body.speed_squared);
        spin_squared = larger(spin_squared, body.spin_squared);
        travel = larger(travel, body.travel);
        way = larger(way, body.way);
    }
};

TUMBLE_INLINE Tally<double> in_one(const Tally<Pack>& eight) {
    return {sum(eight.translation),      sum(eight.rotation),   sum(eight.gravity), largest(eight.speed_squared),
            largest(eight.spin_squared), largest(eight.travel), largest(eight.way)};
}

/// A body's flight over one step, apart from how it turns.
template <class Real> struct Flight {
    Vec3<Real> position, velocity; // after the step
    Tally<Real> tally;

    /// `spun` m/s is what the body's turning adds to the speed of its farthest sphere.
    TUMBLE_INLINE Flight(const IntegrateContext& context, const Vec3<Real>& at, const Vec3<Real>& velocity_before,
                         const Vec3<Real>& force, Real mass, Real share, Real odometer, Real spun) {
        const Real dt(context.dt);
        const Vec3<Real> kick = force * (dt / mass);
        velocity = velocity_before + kick * share;
        position = at + velocity * dt;
        const Vec3<Real> now = velocity - kick * Real(0.5);
        const Vec3<Real> beside = velocity - flow_at(context, at);
        tally.translation = Real(0.5) * mass * dot(now, now);
        tally.gravity = -(mass * dot(spread<Real>(context.gravity), at));
        tally.speed_squared = dot(velocity, velocity);
        tally.way = (root(dot(beside, beside)) + spun) * dt + Real(context.strain_way);
        tally.travel = odometer + tally.way;
    }
};

/// Eight neighbouring slots that all hold single spheres.
struct SpherePack {
    Columns place, velocity, spin, force, torque, orientation;
    Pack inertia, travel;

    SpherePack(const IntegrateContext& context, int first) {
        place = gather([&](int k) TUMBLE_INLINE_LAMBDA { return context.motion[first + k].position; });
        velocity = gather([&](int k) TUMBLE_INLINE_LAMBDA { return context.motion[first + k].velocity; });
        spin = gather([&](int k) TUMBLE_INLINE_LAMBDA { return context.motion[first + k].spin; });
        force = gather([&](int k) TUMBLE_INLINE_LAMBDA { return context.load[first + k].force; });
        torque = gather([&](int k) TUMBLE_INLINE_LAMBDA { return context.load[first + k].torque; });
        orientation = gather([&](int k) TUMBLE_INLINE_LAMBDA { return context.orientation[first + k].q; });
        for (int k = 0; k < lanes; ++k)
            inertia.v[k] = context.shapes[context.shape[first + k]].inertia[0];
        travel = Pack::load_anywhere(context.travel + first);
    }
};

TUMBLE_INLINE Vec3<Pack> xyz(const Columns& c) {
    return {c.x, c.y, c.z};
}

TUMBLE_INLINE void move_spheres(const IntegrateContext& context, int first, Tally<Pack>& tally) {
    const SpherePack in(context, first);
    const Pack dt(context.dt);
    Flight<Pack> flight(context, xyz(in.place), xyz(in.velocity), xyz(in.force), in.velocity.w, in.spin.w, in.travel,
                        Pack(0.0));
    const Vec3<Pack> kick = xyz(in.torque) * (dt / in.inertia);
    const Vec3<Pack> spin = xyz(in.spin) + kick * in.spin.w;
    const Vec3<Pack> now = spin - kick * Pack(0.5);
    const Quaternion<Pack> q =
        turned<Pack>({in.orientation.x, in.orientation.y, in.orientation.z, in.orientation.w}, spin, dt);
    flight.tally.rotation = Pack(0.5) * in.inertia * dot(now, now);
    flight.tally.spin_squared = dot(spin, spin);

    const auto put = [&](const Vec3<Pack>& v, Pack w, auto&& place) TUMBLE_INLINE_LAMBDA {
        for_rows({v.x, v.y, v.z, w}, [&](int k, Quad row) TUMBLE_INLINE_LAMBDA { quad_at(place(first + k)) = row; });
    };
    put(flight.position, in.place.w, [&](int slot) TUMBLE_INLINE_LAMBDA { return context.motion[slot].position; });
    put(flight.velocity, in.velocity.w, [&](int slot) TUMBLE_INLINE_LAMBDA { return context.motion[slot].velocity; });
    put(spin, Pack(1.0), [&](int slot) TUMBLE_INLINE_LAMBDA { return context.motion[slot].spin; });
    put({q.w, q.x, q.y}, q.z, [&](int slot) TUMBLE_INLINE_LAMBDA { return context.orientation[slot].q; });
    flight.tally.travel.store_anywhere(context.travel + first);
    tally.add(flight.tally);
}

using Vec = Vec3<double>;

TUMBLE_INLINE Vec read(const double* from) {
    return {from[0], from[1], from[2]};
}

TUMBLE_INLINE void write(double* to, const Vec& v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

TUMBLE_INLINE void matrix_of(const Quaternion<double>& q, double* r) {
    r[0] = 1 - 2 * (q.y * q.y + q.z * q.z);
    r[1] = 2 * (q.x * q.y - q.w * q.z);
    r[2] = 2 * (q.x * q.z + q.w * q.y);
    r[3] = 2 * (q.x * q.y + q.w * q.z);
    r[4] = 1 - 2 * (q.x * q.x + q.z * q.z);
    r[5] = 2 * (q.y * q.z - q.w * q.x);
    r[6] = 2 * (q.x * q.z - q.w * q.y);
    r[7] = 2 * (q.y * q.z + q.w * q.x);
    r[8] = 1 - 2 * (q.x * q.x + q.y * q.y);
}

/// R I^-1 R^T L: spin of a body with principal inertia I, rotation R and angular momentum L.
TUMBLE_INLINE Vec spin_of(const double* r, const double* inertia, const Vec& momentum) {
    const double x = (r[0] * momentum.x + r[3] * momentum.y + r[6] * momentum.z) / inertia[0];
    const double y = (r[1] * momentum.x + r[4] * momentum.y + r[7] * momentum.z) / inertia[1];
    const double z = (r[2] * momentum.x + r[5] * momentum.y + r[8] * momentum.z) / inertia[2];
    return {r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z};
}

TUMBLE_INLINE double turn_sphere(BodyMotion& motion, BodyOrientation& orientation, const Vec& torque, double inertia,
                                 double dt) {
    const Vec kick = torque * (dt / inertia);
    const Vec next = read(motion.spin) + kick * motion.kick;
    const Vec now = next - kick * 0.5;
    write(motion.spin, next);
    double* q = orientation.q;
    const auto turned_q = turned<double>({q[0], q[1], q[2], q[3]}, next, dt);
    q[0] = turned_q.w;
    q[1] = turned_q.x;
    q[2] = turned_q.y;
    q[3] = turned_q.z;
    return 0.5 * inertia * dot(now, now);
}

/// Angular momentum is kicked in the world frame, which keeps it to rounding; the orientation follows by the midpoint
/// rule, with the spin that belongs to the momentum at the orientation of half a step later. Returns the energy of
/// rotation at the step.
TUMBLE_INLINE double turn_clump(BodyMotion& motion, BodyOrientation& orientation, BodyTurn& turn, const Vec& torque,
                                const double* inertia, double dt) {
    const Vec next = read(turn.momentum) + torque * (dt * motion.kick);
    const Vec now = next - torque * (0.5 * dt);
    write(turn.momentum, next);
    const double energy = 0.5 * dot(now, spin_of(turn.rotation, inertia, now));
    double* q = orientation.q;
    const Quaternion<double> before{q[0], q[1], q[2], q[3]};
    double rotation[9];
    matrix_of(turned<double>(before, spin_of(turn.rotation, inertia, next), 0.5 * dt), rotation);
    const Vec spin = spin_of(rotation, inertia, next);
    const Quaternion<double> after = turned<double>(before, spin, dt);
    matrix_of(after, turn.rotation);
    q[0] = after.w;
    q[1] = after.x;
    q[2] = after.y;
    q[3] = after.z;
    write(motion.spin, spin);
    return energy;
}

TUMBLE_INLINE void move_body(const IntegrateContext& context, int slot, Tally<double>& tally) {
    BodyMotion& motion = context.motion[slot];
    const BodyLoad& load = context.load[slot];
    const ShapeConstants& shape = context.shapes[context.shape[slot]];
    const Vec torque = read(load.torque);
    const double rotation =
        shape.single
            ? turn_sphere(motion, context.orientation[slot], torque, shape.inertia[0], context.dt)
            : turn_clump(motion, context.orientation[slot], context.turn[slot], torque, shape.inertia, context.dt);
    const Vec spin = read(motion.spin);
    const double spin_squared = dot(spin, spin);
    Flight<double> flight(context, read(motion.position), read(motion.velocity), read(load.force), motion.mass,
                          motion.kick, context.travel[slot], shape.single ? 0.0 : root(spin_squared) * shape.reach);
    flight.tally.rotation = rotation;
    flight.tally.spin_squared = spin_squared;
    write(motion.position, flight.position);
    write(motion.velocity, flight.velocity);
    motion.kick = 1;
    context.travel[slot] = flight.tally.travel;
    tally.add(flight.tally);
}

TUMBLE_INLINE bool all_single(const IntegrateContext& context, int first) {
    bool all = true;
    for (int k = 0; k < lanes; ++k)
        all = all && context.shapes[context.shape[first + k]].single;
    return all;
}

} // namespace

IntegrateSums integrate(const IntegrateContext& context) {
    Tally<Pack> eights;
    Tally<double> tally;
    int slot = context.begin;
    for (; slot + lanes <= context.end; slot += lanes) {
        if (all_single(context, slot))
            move_spheres(context, slot, eights);
        else
            for (int k = 0; k < lanes; ++k)
                move_body(context, slot + k, tally);
    }
    for (; slot < context.end; ++slot)
        move_body(context, slot, tally);
    tally.add(in_one(eights));
    // A speed that is not a number shows in the sums, one that is absurd in the extremes.
    const bool finite = tally.translation + tally.rotation < 1e300 && tally.speed_squared + tally.spin_squared < 1e30;
    return {tally.translation, tally.rotation,      tally.gravity,      tally.travel,
            tally.way,         tally.speed_squared, tally.spin_squared, finite};
}

} // namespace tumble::sim3d::TUMBLE_ISA
