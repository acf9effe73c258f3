#include "sim2d/kernels/isa.h"

namespace tumble::sim2d::TUMBLE_ISA {

namespace {

constexpr int lanes = Pack::lanes;

/// Sums and extremes of one body, or of eight in lanes.
template <class Real> struct Tally {
    Real translation{0.0}, rotation{0.0}, gravity{0.0}, damped{0.0}; // J, at the step
    Real speed_squared{0.0}, spin_squared{0.0};                      // of the next half step
    Real travel{-1e300}, way{0.0};                                   // m, the odometer and its advance

    TUMBLE_INLINE void add(const Tally& body) {
        translation = translation + body.translation;
        rotation = rotation + body.rotation;
        gravity = gravity + body.gravity;
        damped = damped + body.damped;
        speed_squared = larger(speed_squared, body.speed_squared);
        spin_squared = larger(spin_squared, body.spin_squared);
        add_way(body.travel, body.way);
    }
    TUMBLE_INLINE void add_way(Real odometer, Real advance) {
        travel = larger(travel, odometer);
        way = larger(way, advance);
    }
};

TUMBLE_INLINE Tally<double> in_one(const Tally<Pack>& eight) {
    return {sum(eight.translation),       sum(eight.rotation),         sum(eight.gravity),    sum(eight.damped),
            largest(eight.speed_squared), largest(eight.spin_squared), largest(eight.travel), largest(eight.way)};
}

/// One velocity over one step: (3.13) and (3.14) with half a step between force and velocity, and the mass-proportional
/// damping of Cundall and Strack 1979. `kick` is the share of the step that is due.
template <class Real> struct Kicked {
    Real next, now; // half a step later; at the step

    TUMBLE_INLINE Kicked(Real before, Real acceleration, Real kick, Real dt, Real damping) {
        const Real half = Real(0.5) * damping * dt;
        next =
            (before * (Real(1.0) - half * (kick + kick - Real(1.0))) + acceleration * dt * kick) / (Real(1.0) + half);
        now = before + (next - before) * (Real(1.0) - Real(0.5) / kick);
    }
};

/// How far a row went beside the mean flow, m.
template <class Real> TUMBLE_INLINE Real way_of(const IntegrateContext& context, Real x, Real y, Real vx, Real vy) {
    const double* g = context.flow_gradient;
    const Real bx = vx - (Real(context.flow_velocity[0]) + Real(g[0]) * x + Real(g[1]) * y);
    const Real by = vy - (Real(context.flow_velocity[1]) + Real(g[2]) * x + Real(g[3]) * y);
    return root(bx * bx + by * by) * Real(context.dt) + Real(context.strain_way);
}

/// A body's flight over one step.
template <class Real> struct Flight {
    Real x, y, vx, vy, spin; // after the step
    Tally<Real> tally;       // without the way

    TUMBLE_INLINE Flight(const IntegrateContext& context, const Real (&place)[2], const Real (&velocity)[3],
                         const Real (&load)[3], Real mass, Real inertia, Real kick) {
        const Real dt(context.dt);
        const Real damping(context.damping);
        const Kicked<Real> along(velocity[0], load[0] / mass, kick, dt, damping);
        const Kicked<Real> up(velocity[1], load[1] / mass, kick, dt, damping);
        const Kicked<Real> turn(velocity[2], load[2] / inertia, kick, dt, damping);
        vx = along.next;
        vy = up.next;
        spin = turn.next;
        x = place[0] + vx * dt;
        y = place[1] + vy * dt;
        tally.translation = Real(0.5) * mass * (along.now * along.now + up.now * up.now);
        tally.rotation = Real(0.5) * inertia * (turn.now * turn.now);
        tally.gravity = -(mass * (Real(context.gravity[0]) * place[0] + Real(context.gravity[1]) * place[1]));
        // By the trapezoidal rule a body's first instant counts half.
        tally.damped = Real(2.0) * damping * dt * kick * (tally.translation + tally.rotation);
        tally.speed_squared = vx * vx + vy * vy;
        tally.spin_squared = spin * spin;
    }
};

/// Eight neighbouring slots that all hold single discs.
TUMBLE_INLINE void move_discs(const IntegrateContext& context, int first, Tally<Pack>& tally) {
    const Columns place = gather([&](int k) TUMBLE_INLINE_LAMBDA { return &context.rows[first + k].x; });
    const Columns motion = gather([&](int k) TUMBLE_INLINE_LAMBDA { return &context.rows[first + k].vx; });
    const Columns load = gather([&](int k) TUMBLE_INLINE_LAMBDA { return &context.loads[first + k].fx; });
    Pack inertia;
    for (int k = 0; k < lanes; ++k)
        inertia.v[k] = context.shapes[context.shape[first + k]].inertia;
    Flight<Pack> flight(context, {place.x, place.y}, {motion.x, motion.y, motion.z}, {load.x, load.y, load.z}, place.w,
                        inertia, motion.w);
    flight.tally.way = way_of(context, place.x, place.y, flight.vx, flight.vy);
    flight.tally.travel = Pack::load_anywhere(context.travel + first) + flight.tally.way;
    flight.tally.travel.store_anywhere(context.travel + first);
    const Pack angle = Pack::load_anywhere(context.angle + first) + flight.spin * Pack(context.dt);
    angle.store_anywhere(context.angle + first);
    for_rows({flight.x, flight.y, place.z, place.w},
             [&](int k, Quad row) TUMBLE_INLINE_LAMBDA { quad_at(&context.rows[first + k].x) = row; });
    for_rows({flight.vx, flight.vy, flight.spin, Pack(1.0)},
             [&](int k, Quad row) TUMBLE_INLINE_LAMBDA { quad_at(&context.rows[first + k].vx) = row; });
    tally.add(flight.tally);
}

/// A clump's discs go with it; each has its own odometer.
TUMBLE_INLINE void carry_discs(const IntegrateContext& context, int slot, Tally<double>& tally) {
    const ShapeConstants& shape = context.shapes[context.shape[slot]];
    Row* const discs = context.rows + context.first_disc[slot];
    double* const travel = context.travel + context.first_disc[slot];
    place_discs(shape, context.rows[slot], context.angle[slot], discs);
    // A disc's speed at the step's end is not that of the whole step: the arm has turned meanwhile.
    const double turned = context.rows[slot].spin * context.dt;
    const double bent = turned * turned * shape.reach;
    for (int k = 0; k < shape.exposed_count; ++k) {
        const double way = way_of(context, discs[k].x, discs[k].y, discs[k].vx, discs[k].vy) + bent;
        travel[k] += way;
        tally.add_way(travel[k], way);
    }
}

TUMBLE_INLINE void move_body(const IntegrateContext& context, int slot, Tally<double>& tally) {
    Row& row = context.rows[slot];
    const Load& load = context.loads[slot];
    const ShapeConstants& shape = context.shapes[context.shape[slot]];
    Flight<double> flight(context, {row.x, row.y}, {row.vx, row.vy, row.spin}, {load.fx, load.fy, load.torque},
                          row.mass, shape.inertia, row.kick);
    if (shape.single) {
        flight.tally.way = way_of(context, row.x, row.y, flight.vx, flight.vy);
        flight.tally.travel = context.travel[slot] += flight.tally.way;
    }
    context.angle[slot] += flight.spin * context.dt;
    row.x = flight.x;
    row.y = flight.y;
    row.vx = flight.vx;
    row.vy = flight.vy;
    row.spin = flight.spin;
    row.kick = 1;
    tally.add(flight.tally);
    if (!shape.single)
        carry_discs(context, slot, tally);
}

TUMBLE_INLINE bool all_single(const IntegrateContext& context, int first) {
    bool all = true;
    for (int k = 0; k < lanes; ++k)
        all = all && context.rows[first + k].radius > 0;
    return all;
}

} // namespace

MotionSums integrate(const IntegrateContext& context) {
    Tally<Pack> eights;
    Tally<double> tally;
    int slot = context.begin;
    for (; slot + lanes <= context.end; slot += lanes) {
        if (all_single(context, slot))
            move_discs(context, slot, eights);
        else
            for (int k = 0; k < lanes; ++k)
                move_body(context, slot + k, tally);
    }
    for (; slot < context.end; ++slot)
        move_body(context, slot, tally);
    tally.add(in_one(eights));
    // A speed that is not a number shows in the sums, one that is absurd in the extremes.
    const bool finite = tally.translation + tally.rotation < 1e300 && tally.speed_squared + tally.spin_squared < 1e30;
    return {tally.translation, tally.rotation,      tally.gravity,      tally.damped, tally.travel,
            tally.way,         tally.speed_squared, tally.spin_squared, finite};
}

} // namespace tumble::sim2d::TUMBLE_ISA
