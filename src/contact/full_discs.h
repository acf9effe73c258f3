#pragma once

#include "contact/disc_touch.h"
#include "contact/full_law.h"

namespace tumble::contact {

/// What DiscPush lacks.
template <class Real> struct FullDiscPush : DiscPush<Real> {
    Real torque; // N m on X, counter-clockwise; Y gets the opposite
    Further<Real> further;
    Real lost_rolling_damping; // J in this step, by power
    Real lost_rolling_sliding; // J in this step, exact
};

/// A law of discs (CundallStrack, HertzDiscs) with all that a pair may add to it, as FullLaw is for spheres: the same
/// functions, asked in the plane. The rolling spring is the third component's.
template <class DiscLaw> struct FullDiscs {
    DiscLaw law;
    PairConstants pair;

    /// `turn.spin` of X relative to Y in rad/s, half a step ago, its third component alone.
    template <class Real>
    TUMBLE_INLINE FullDiscPush<Real> push(const DiscTouch<Real>& touch, const Turn<Real>& turn,
                                          const DiscMemory<Real>& memory, const Further<Real>& further, Real dt) const {
        const Real none(0.0);
        FullDiscPush<Real> push;
        push.further.impact_speed = impact_speed_of(further, touch.normal_rate);
        const Real share = damping_share_at(push.further.impact_speed, pair);
        const Real friction = friction_of(larger(touch.shear_rate, -touch.shear_rate), pair);
        static_cast<DiscPush<Real>&>(push) = law.push(touch, memory, friction, share, dt);

        const Touch<Real> seen{touch.overlap, {Real(1.0), none, none}, {none, none, none}, touch.radius, touch.mass,
                               share};
        const RollingPush<Real> rolling =
            rolling_push(seen, turn, push.normal, law.secant(touch), pair, further.rolling, dt);
        push.torque = rolling.torque.z;
        push.further.rolling = rolling.memory;
        push.lost_rolling_damping = rolling.lost_damping;
        push.lost_rolling_sliding = rolling.lost_sliding;
        push.lost_history = push.lost_history + rolling.lost_history;
        return push;
    }
};

} // namespace tumble::contact
