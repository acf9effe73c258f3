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

/// A row of four numbers, or eight rows as columns.
template <class Real> struct Row { Real x, y, z, w; };

template <class Real> TUMBLE_INLINE Vec3<Real> xyz(const Row<Real>& row) {
    return {row.x, row.y, row.z};
}

/// One body's slot. `row_of(slot)` points to four numbers of its.
struct One {
    using Real = double;
    int slot;

    template <class RowOf> TUMBLE_INLINE Row<double> load(RowOf&& row_of) const {
        const double* row = row_of(slot);
        return {row[0], row[1], row[2], row[3]};
    }
    template <class RowOf> TUMBLE_INLINE void store(RowOf&& row_of, const Vec3<double>& v, double w) const {
        double* row = row_of(slot);
        row[0] = v.x;
        row[1] = v.y;
        row[2] = v.z;
        row[3] = w;
    }
    template <class Value> TUMBLE_INLINE double each(Value&& value) const { return value(slot); }
    TUMBLE_INLINE double load_line(const double* values) const { return values[slot]; }
    TUMBLE_INLINE void store_line(double* values, double value) const { values[slot] = value; }
};

/// Eight neighbouring slots, the same rows in packs.
struct Eight {
    using Real = Pack;
    int first;

    template <class RowOf> TUMBLE_INLINE Row<Pack> load(RowOf&& row_of) const {
        const Columns c = gather([&](int k) TUMBLE_INLINE_LAMBDA { return row_of(first + k); });
        return {c.x, c.y, c.z, c.w};
    }
    template <class RowOf> TUMBLE_INLINE void store(RowOf&& row_of, const Vec3<Pack>& v, Pack w) const {
        for_rows({v.x, v.y, v.z, w}, [&](int k, Quad row) TUMBLE_INLINE_LAMBDA { quad_at(row_of(first + k)) = row; });
    }
    template <class Value> TUMBLE_INLINE Pack each(Value&& value) const {
        Pack pack;
        for (int k = 0; k < lanes; ++k)
            pack.v[k] = value(first + k);
        return pack;
    }
    TUMBLE_INLINE Pack load_line(const double* values) const { return Pack::load_anywhere(values + first); }
    TUMBLE_INLINE void store_line(double* values, Pack value) const { value.store_anywhere(values + first); }
};

/// Row-major rotation matrix.
template <class Real> struct Rotation {
    Real r[9];

    TUMBLE_INLINE explicit Rotation(const Quaternion<Real>& q) {
        const Real one(1.0);
        const Real two(2.0);
        r[0] = one - two * (q.y * q.y + q.z * q.z);
        r[1] = two * (q.x * q.y - q.w * q.z);
        r[2] = two * (q.x * q.z + q.w * q.y);
        r[3] = two * (q.x * q.y + q.w * q.z);
        r[4] = one - two * (q.x * q.x + q.z * q.z);
        r[5] = two * (q.y * q.z - q.w * q.x);
        r[6] = two * (q.x * q.z - q.w * q.y);
        r[7] = two * (q.y * q.z + q.w * q.x);
        r[8] = one - two * (q.x * q.x + q.y * q.y);
    }
    /// From the rows of a BodyTurn.
    TUMBLE_INLINE Rotation(const Row<Real>& first, const Row<Real>& second, const Row<Real>& third)
        : r{first.w, second.x, second.y, second.z, second.w, third.x, third.y, third.z, third.w} {}

    /// R I^-1 R^T L: spin of a body with angular momentum L; `per_inertia` is the inverse of the principal inertia.
    TUMBLE_INLINE Vec3<Real> spin_of(const Vec3<Real>& per_inertia, const Vec3<Real>& momentum) const {
        const Real x = (r[0] * momentum.x + r[3] * momentum.y + r[6] * momentum.z) * per_inertia.x;
        const Real y = (r[1] * momentum.x + r[4] * momentum.y + r[7] * momentum.z) * per_inertia.y;
        const Real z = (r[2] * momentum.x + r[5] * momentum.y + r[8] * momentum.z) * per_inertia.z;
        return {r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z};
    }
};

/// How a body turns in one step.
template <class Real> struct Turning {
    Vec3<Real> spin; // rad/s, after the step's kick
    Quaternion<Real> q;
    Real energy; // J, at the step
    Real spun;   // m/s, what the turning adds to the speed of the farthest sphere
};

template <class Real> struct Torqued {
    Quaternion<Real> q;
    Vec3<Real> spin, torque; // rad/s before the step's kick, N m
    Real share;              // of the kick that is due
};

template <bool turns, class Slots, class Real = typename Slots::Real>
TUMBLE_INLINE Turning<Real> turn_spheres(const IntegrateContext& context, Slots slots, const Torqued<Real>& body) {
    const Real dt(context.dt);
    const Real inertia =
        slots.each([&](int slot) TUMBLE_INLINE_LAMBDA { return context.shapes[context.shape[slot]].inertia[0]; });
    const Vec3<Real> kick = body.torque * (dt / inertia);
    const Vec3<Real> spin = body.spin + kick * body.share;
    const Vec3<Real> now = spin - kick * Real(0.5);
    const Real energy = Real(0.5) * inertia * dot(now, now);
    if constexpr (turns)
        return {spin, turned<Real>(body.q, spin, dt), energy, Real(0.0)};
    else
        return {spin, body.q, energy, Real(0.0)};
}

/// Angular momentum is kicked in the world frame, which keeps it to rounding; the orientation follows by the midpoint
/// rule, with the spin that belongs to the momentum at the orientation of half a step later.
template <class Slots, class Real = typename Slots::Real>
TUMBLE_INLINE Turning<Real> turn_clumps(const IntegrateContext& context, Slots slots, const Torqued<Real>& body) {
    static_assert(sizeof(BodyTurn) == 12 * sizeof(double)); // momentum and rotation, as three rows
    const auto row = [&](int which) TUMBLE_INLINE_LAMBDA {
        return [&context, which](int slot)
                   TUMBLE_INLINE_LAMBDA { return reinterpret_cast<double*>(&context.turn[slot]) + 4 * which; };
    };
    const auto per_inertia = [&](int axis) TUMBLE_INLINE_LAMBDA {
        return Real(1.0) / slots.each([&](int slot) TUMBLE_INLINE_LAMBDA {
            return context.shapes[context.shape[slot]].inertia[axis];
        });
    };
    const Real dt(context.dt);
    const Row<Real> first = slots.load(row(0));
    const Rotation<Real> before(first, slots.load(row(1)), slots.load(row(2)));
    const Vec3<Real> inverse{per_inertia(0), per_inertia(1), per_inertia(2)};
    const Vec3<Real> momentum = xyz(first) + body.torque * (dt * body.share);
    const Vec3<Real> now = momentum - body.torque * (Real(0.5) * dt);
    const Real energy = Real(0.5) * dot(now, before.spin_of(inverse, now));
    const Rotation<Real> midway(turned<Real>(body.q, before.spin_of(inverse, momentum), Real(0.5) * dt));
    const Vec3<Real> spin = midway.spin_of(inverse, momentum);
    const Quaternion<Real> q = turned<Real>(body.q, spin, dt);
    const Rotation<Real> after(q);
    slots.store(row(0), momentum, after.r[0]);
    slots.store(row(1), {after.r[1], after.r[2], after.r[3]}, after.r[4]);
    slots.store(row(2), {after.r[5], after.r[6], after.r[7]}, after.r[8]);
    const Real reach =
        slots.each([&](int slot) TUMBLE_INLINE_LAMBDA { return context.shapes[context.shape[slot]].reach; });
    return {spin, q, energy, root(dot(spin, spin)) * reach};
}

enum class Kind { clump, sphere, sphere_that_keeps_its_orientation };

/// Moves bodies that are all of a kind.
template <Kind kind, class Slots, class Real = typename Slots::Real>
TUMBLE_INLINE void move(const IntegrateContext& context, Slots slots, Tally<Real>& tally) {
    const auto position = [&](int slot) TUMBLE_INLINE_LAMBDA { return context.motion[slot].position; };
    const auto velocity = [&](int slot) TUMBLE_INLINE_LAMBDA { return context.motion[slot].velocity; };
    const auto spin = [&](int slot) TUMBLE_INLINE_LAMBDA { return context.motion[slot].spin; };
    const auto orientation = [&](int slot) TUMBLE_INLINE_LAMBDA { return context.orientation[slot].q; };
    const Row<Real> at = slots.load(position);
    const Row<Real> speed = slots.load(velocity);
    const Row<Real> turning = slots.load(spin);
    constexpr bool turns = kind != Kind::sphere_that_keeps_its_orientation;
    Row<Real> q{};
    if constexpr (turns)
        q = slots.load(orientation);
    const Row<Real> force = slots.load([&](int slot) TUMBLE_INLINE_LAMBDA { return context.load[slot].force; });
    const Row<Real> torque = slots.load([&](int slot) TUMBLE_INLINE_LAMBDA { return context.load[slot].torque; });

    const Torqued<Real> body{{q.x, q.y, q.z, q.w}, xyz(turning), xyz(torque), turning.w};
    Turning<Real> turned;
    if constexpr (kind == Kind::clump)
        turned = turn_clumps(context, slots, body);
    else
        turned = turn_spheres<turns>(context, slots, body);
    Flight<Real> flight(context, xyz(at), xyz(speed), xyz(force), speed.w, turning.w, slots.load_line(context.travel),
                        turned.spun);
    flight.tally.rotation = turned.energy;
    flight.tally.spin_squared = dot(turned.spin, turned.spin);

    slots.store(position, flight.position, at.w);
    slots.store(velocity, flight.velocity, speed.w);
    slots.store(spin, turned.spin, Real(1.0));
    if constexpr (turns)
        slots.store(orientation, {turned.q.w, turned.q.x, turned.q.y}, turned.q.z);
    slots.store_line(context.travel, flight.tally.travel);
    tally.add(flight.tally);
}

TUMBLE_INLINE bool is_single(const IntegrateContext& context, int slot) {
    return context.shapes[context.shape[slot]].single;
}

TUMBLE_INLINE int singles_of_eight(const IntegrateContext& context, int first) {
    int count = 0;
    for (int k = 0; k < lanes; ++k)
        count += is_single(context, first + k);
    return count;
}

TUMBLE_INLINE void move_one(const IntegrateContext& context, int slot, Tally<double>& tally) {
    if (!is_single(context, slot))
        move<Kind::clump>(context, One{slot}, tally);
    else if (context.turn_spheres)
        move<Kind::sphere>(context, One{slot}, tally);
    else
        move<Kind::sphere_that_keeps_its_orientation>(context, One{slot}, tally);
}

} // namespace

MotionSums integrate(const IntegrateContext& context) {
    Tally<Pack> eights;
    Tally<double> tally;
    int slot = context.begin;
    for (; slot + lanes <= context.end; slot += lanes) {
        const int singles = singles_of_eight(context, slot);
        if (singles == 0)
            move<Kind::clump>(context, Eight{slot}, eights);
        else if (singles == lanes && context.turn_spheres)
            move<Kind::sphere>(context, Eight{slot}, eights);
        else if (singles == lanes)
            move<Kind::sphere_that_keeps_its_orientation>(context, Eight{slot}, eights);
        else
            for (int k = 0; k < lanes; ++k)
                move_one(context, slot + k, tally);
    }
    for (; slot < context.end; ++slot)
        move_one(context, slot, tally);
    tally.add(in_one(eights));
    // A speed that is not a number shows in the sums, one that is absurd in the extremes.
    const bool finite = tally.translation + tally.rotation < 1e300 && tally.speed_squared + tally.spin_squared < 1e30;
    return {tally.translation, tally.rotation,      tally.gravity,      0,     tally.travel,
            tally.way,         tally.speed_squared, tally.spin_squared, finite};
}

} // namespace tumble::sim3d::TUMBLE_ISA
