#pragma once

#include "contact/falling_restitution.h"
#include "contact/law.h"
#include "contact/rolling_cdt.h"
#include "contact/rolling_epsd.h"
#include "contact/weakening_friction.h"

namespace tumble::contact {

/// What a contact remembers beside its tangential spring where a law of the additions needs it.
template <class Real> struct Further {
    Memory<Real> rolling;
    Real impact_speed; // m/s, when the contact began; 0: it has just begun
};

/// What the additions do beside Push.
template <class Real> struct FullPush : Push<Real> {
    Vec3<Real> torque; // N m on a; b gets the opposite
    Further<Real> further;
    Real lost_rolling_damping; // J in this step, by power
    Real lost_rolling_sliding; // J in this step, exact
};

// The slowest impact that counts: a contact that begins at rest has one as well.
constexpr double least_impact_speed = 1e-12; // m/s

template <class Real> TUMBLE_INLINE Real impact_speed_of(const Further<Real>& kept, Real approach) {
    const Real first = larger(approach, Real(least_impact_speed));
    return select(kept.impact_speed > Real(0.0), kept.impact_speed, first);
}

/// The rolling torque of the pair's law. `force` N, normal; `elastic` N, its spring's part.
template <class Real>
TUMBLE_INLINE RollingPush<Real> rolling_push(const Touch<Real>& touch, const Turn<Real>& turn, Real force, Real elastic,
                                             const PairConstants& pair, const Memory<Real>& memory, Real dt) {
    const Real limit = Real(pair.rolling_friction) * touch.radius * larger(force, -force);
    if (pair.rolling == RollingLaw::epsd)
        return Epsd::push(touch, turn, limit, elastic / larger(touch.overlap, Real(1e-300)), pair, memory, dt);
    if (pair.rolling == RollingLaw::cdt)
        return Cdt::push(touch, turn, limit, dt);
    return {};
}

/// How the dashpots of an impact that began at `speed` (m/s) are scaled.
template <class Real> TUMBLE_INLINE Real damping_share_at(Real speed, const PairConstants& pair) {
    return pair.restitution_exponent > 0 ? damping_at(speed, pair) : Real(1.0);
}

/// Friction at a slip of that speed, m/s.
template <class Real> TUMBLE_INLINE Real friction_of(Real speed, const PairConstants& pair) {
    return pair.sliding_speed > 0 ? friction_at(speed, pair) : Real(pair.friction);
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
        const NormalPush<Real> normal = Normal::push(seen, normal_rate, pair);
        const Real sum = normal.elastic + normal.viscous;
        const Real force = limit_force ? larger(sum, Real(0.0)) : sum;

        const Vec3<Real> slip_rate = touch.velocity - touch.normal * normal_rate;
        const Real limit = friction_of(root(dot(slip_rate, slip_rate)), pair) * larger(force, -force);
        const TangentialPush<Real> tangential =
            Tangential::push(seen, slip_rate, limit, normal.stiffness, pair, memory, dt);
        const RollingPush<Real> rolling = rolling_push(touch, turn, force, normal.elastic, pair, further.rolling, dt);

        // The dashpot's work over the step is its force times the velocity at the step, half a kick later.
        const Real rate_now = normal_rate + Real(0.5) * force * (dt / touch.mass);
        push.force = touch.normal * force + tangential.force;
        push.torque = rolling.torque;
        push.memory = tangential.memory;
        push.further.rolling = rolling.memory;
        push.stored_normal = normal.stored;
        push.lost_normal_damping = -((force - normal.elastic) * rate_now * dt);
        push.lost_tangential_damping = tangential.lost_damping;
        push.lost_sliding = tangential.lost_sliding;
        push.lost_rolling_damping = rolling.lost_damping;
        push.lost_rolling_sliding = rolling.lost_sliding;
        push.lost_history = tangential.lost_history + rolling.lost_history;
        return push;
    }
};

} // namespace tumble::contact
