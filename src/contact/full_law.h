#pragma once

#include "contact/dmt.h"
#include "contact/falling_restitution.h"
#include "contact/jkr.h"
#include "contact/law.h"
#include "contact/rolling_cdt.h"
#include "contact/rolling_epsd.h"
#include "contact/rolling_viscous.h"
#include "contact/sjkr.h"
#include "contact/weakening_friction.h"

namespace tumble::contact {

/// What a contact remembers beside its tangential spring where a law of the additions needs it.
template <class Real> struct Further {
    Memory<Real> rolling;
    Real impact_speed; // m/s, when the contact began; 0: it has just begun
    Real bonded;       // 1 where a neck may hold beyond contact, else 0
    Real bond_energy;  // J, what is lost when it tears now
};

/// What the additions do beside Push.
template <class Real> struct FullPush : Push<Real> {
    Vec3<Real> torque; // N m on a; b gets the opposite
    Further<Real> further;
    Real lost_rolling_damping; // J in this step, by power
    Real lost_rolling_sliding; // J in this step, exact
    Real lost_adhesion;        // J in this step
    Real holds;                // 1 where the two touch or stick, else 0
};

// The slowest impact that counts: a contact that begins at rest has one as well.
constexpr double least_impact_speed = 1e-12; // m/s

template <class Real> TUMBLE_INLINE Real impact_speed_of(const Further<Real>& kept, Real approach) {
    const Real first = larger(approach, Real(least_impact_speed));
    return select(kept.impact_speed > Real(0.0), kept.impact_speed, first);
}

/// The rolling torque of the pair's laws. `pressing` N, normal; `stiffness` N/m, normal force over overlap.
template <class Real>
TUMBLE_INLINE RollingPush<Real> rolling_push(const Touch<Real>& touch, const Turn<Real>& turn, Real pressing,
                                             Real stiffness, const PairConstants& pair, const Memory<Real>& memory,
                                             Real dt) {
    const Real limit = Real(pair.rolling_friction) * touch.radius * larger(pressing, -pressing);
    RollingPush<Real> push{};
    if (pair.rolling == RollingLaw::epsd)
        push = Epsd::push(touch, turn, limit, stiffness, pair, memory, dt);
    else if (pair.rolling == RollingLaw::cdt)
        push = Cdt::push(touch, turn, limit, dt);
    if (pair.rolling_time > 0) {
        const Real per_time = Real(pair.rolling_time) * touch.radius * larger(pressing, -pressing);
        const RollingPush<Real> viscous = ViscousRolling::push(touch, turn, per_time, dt);
        push.torque = push.torque + viscous.torque;
        push.lost_damping = push.lost_damping + viscous.lost_damping;
    }
    return push;
}

/// How the dashpots of an impact that began at `speed` (m/s) are scaled.
template <class Real> TUMBLE_INLINE Real damping_share_at(Real speed, const PairConstants& pair) {
    return pair.by_impact_speed() ? damping_at(speed, pair) : Real(1.0);
}

/// Friction at a slip of that speed, m/s.
template <class Real> TUMBLE_INLINE Real friction_of(Real speed, const PairConstants& pair) {
    return pair.sliding_speed > 0 ? friction_at(speed, pair) : Real(pair.friction);
}

/// A normal push with the pair's adhesion in it.
template <class Real> struct Adhered {
    NormalPush<Real> normal;
    Real squeeze; // N, what presses the surfaces together beside the load
    Real pull;    // N, no more than this may they pull at each other where the dashpot must not
    Real holds;   // 1 where the two touch or stick, else 0
};

/// JKR in place of Hertz. Friction feels the load and twice the pull-off force (Thornton 1991).
template <class Real>
TUMBLE_INLINE Adhered<Real> stuck(const Touch<Real>& touch, Real normal_rate, const PairConstants& pair,
                                  const Further<Real>& kept) {
    const Real none(0.0);
    const Real reach = Jkr::reach(touch.radius, pair);
    Touch<Real> held = touch;
    held.overlap = larger(touch.overlap, none - reach);
    const NormalPush<Real> normal = Jkr::push(held, normal_rate, pair);
    return {normal, Real(3 * std::numbers::pi * pair.work_of_adhesion) * touch.radius,
            larger(none - normal.elastic, none), Jkr::holds(touch.overlap, reach, kept.bonded)};
}

template <class Normal, class Real>
TUMBLE_INLINE Adhered<Real> adhered(const Touch<Real>& touch, Real normal_rate, const PairConstants& pair,
                                    const Further<Real>& kept) {
    if (pair.adhesion == AdhesionLaw::jkr)
        return stuck(touch, normal_rate, pair, kept);
    NormalPush<Real> normal = Normal::push(touch, normal_rate, pair);
    Real pull(0.0);
    if (pair.adhesion == AdhesionLaw::sjkr) {
        pull = Sjkr::pull(touch, pair);
        normal.stored = normal.stored + Sjkr::stored(touch, pair);
    }
    if (pair.adhesion == AdhesionLaw::dmt) {
        pull = Dmt::pull(touch, pair);
        normal.stored = normal.stored + Dmt::stored(touch, pair);
    }
    normal.elastic = normal.elastic - pull;
    return {normal, pull, pull, Real(1.0)};
}

/// Takes away what a neck that does not hold would do, and books what went with it.
template <class Real>
TUMBLE_INLINE void let_go(FullPush<Real>& push, const Memory<Real>& memory, const Further<Real>& kept) {
    const Real holds = push.holds;
    const Real torn = Real(1.0) - holds;
    const Further<Real> further = push.further;
    push.force = push.force * holds;
    push.torque = push.torque * holds;
    push.memory = {push.memory.spring * holds, push.memory.energy * holds};
    push.normal_viscous = push.normal_viscous * holds;
    push.tangential_viscous = push.tangential_viscous * holds;
    push.further = {{further.rolling.spring * holds, further.rolling.energy * holds},
                    further.impact_speed * holds,
                    holds,
                    push.stored_normal * holds};
    push.lost_adhesion = kept.bond_energy * torn;
    push.stored_normal = push.stored_normal * holds;
    push.lost_normal_damping = push.lost_normal_damping * holds;
    push.lost_tangential_damping = push.lost_tangential_damping * holds;
    push.lost_sliding = push.lost_sliding * holds;
    push.lost_rolling_damping = push.lost_rolling_damping * holds;
    push.lost_rolling_sliding = push.lost_rolling_sliding * holds;
    push.lost_history = push.lost_history * holds + (memory.energy + kept.rolling.energy) * torn;
}

/// Law with all that a pair may add to it: docs/laws.md. Each addition is asked for by a number of the pair that is not
/// zero, and changes no bit where it is not.
template <class Normal, class Tangential> struct FullLaw {
    bool limit_force = false;

    /// As Law::push.
    template <class Real>
    TUMBLE_INLINE FullPush<Real> push(const Touch<Real>& touch, const Turn<Real>& turn, const PairConstants& pair,
                                      const Memory<Real>& memory, const Further<Real>& further, Real dt) const {
        const Real normal_rate = dot(touch.velocity, touch.normal);
        FullPush<Real> push;
        Touch<Real> seen = touch;
        push.further.impact_speed = impact_speed_of(further, -normal_rate);
        seen.damping_share = seen.damping_share * damping_share_at(push.further.impact_speed, pair);
        const Adhered<Real> adhered_push = adhered<Normal>(seen, normal_rate, pair, further);
        const NormalPush<Real>& normal = adhered_push.normal;
        const Real squeeze = adhered_push.squeeze;
        const Real sum = normal.elastic + normal.viscous;
        const Real force = limit_force ? larger(sum + adhered_push.pull, Real(0.0)) - adhered_push.pull : sum;
        const Real pressing = larger(force + squeeze, -(force + squeeze));

        const Vec3<Real> slip_rate = touch.velocity - touch.normal * normal_rate;
        const Real limit = friction_of(root(dot(slip_rate, slip_rate)), pair) * pressing;
        const TangentialPush<Real> tangential =
            Tangential::push(seen, slip_rate, limit, normal.stiffness, pair, memory, dt);
        const RollingPush<Real> rolling =
            rolling_push(touch, turn, pressing, Normal::secant(normal.stiffness, pair), pair, further.rolling, dt);

        // The dashpot's work over the step is its force times the velocity at the step, half a kick later.
        const Real rate_now = normal_rate + Real(0.5) * force * (dt / touch.mass);
        push.force = touch.normal * force + tangential.force;
        push.torque = rolling.torque;
        push.memory = tangential.memory;
        push.normal_viscous = force - normal.elastic;
        push.tangential_viscous = tangential.viscous;
        push.further.rolling = rolling.memory;
        push.stored_normal = normal.stored;
        push.lost_normal_damping = -((force - normal.elastic) * rate_now * dt);
        push.lost_tangential_damping = tangential.lost_damping;
        push.lost_sliding = tangential.lost_sliding;
        push.lost_rolling_damping = rolling.lost_damping;
        push.lost_rolling_sliding = rolling.lost_sliding;
        push.lost_history = tangential.lost_history + rolling.lost_history;
        push.lost_adhesion = push.further.bonded = push.further.bond_energy = Real(0.0);
        push.holds = adhered_push.holds;
        if (pair.adhesion == AdhesionLaw::jkr)
            let_go(push, memory, further);
        return push;
    }
};

} // namespace tumble::contact
