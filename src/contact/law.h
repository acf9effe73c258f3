#pragma once

#include "contact/linear.h"
#include "contact/mindlin.h"

namespace tumble::contact {

/// Books the dashpots' work at the velocity of the step where more than this contact changes it until then: by `ahead`,
/// m/s of a's surface relative to b's, half a step of gravity or of a wall that speeds up.
template <class Real>
TUMBLE_INLINE void book_ahead(Push<Real>& push, const Vec3<Real>& normal, const Vec3<Real>& ahead, Real dt) {
    push.lost_normal_damping = push.lost_normal_damping - push.normal_viscous * dot(ahead, normal) * dt;
    push.lost_tangential_damping = push.lost_tangential_damping - dot(push.tangential_viscous, ahead) * dt;
}

/// A normal and a tangential law put together. `limit_force` true: the normal force never pulls at the end of a
/// rebound.
template <class Normal, class Tangential> struct Law {
    bool limit_force = false;

    /// dt in s; touch.velocity is that of half a step ago, as leapfrog has it.
    template <class Real>
    TUMBLE_INLINE Push<Real> push(const Touch<Real>& touch, const PairConstants& pair, const Memory<Real>& memory,
                                  Real dt) const {
        const Real normal_rate = dot(touch.velocity, touch.normal);
        const NormalPush<Real> normal = Normal::push(touch, normal_rate, pair);
        const Real sum = normal.elastic + normal.viscous;
        const Real force = limit_force ? larger(sum, Real(0.0)) : sum;
        const Vec3<Real> slip_rate = touch.velocity - touch.normal * normal_rate;
        const Real limit = Real(pair.friction) * larger(force, -force);
        const TangentialPush<Real> tangential =
            Tangential::push(touch, slip_rate, limit, normal.stiffness, pair, memory, dt);

        // The dashpot's work over the step is its force times the velocity at the step, half a kick later.
        const Real rate_now = normal_rate + Real(0.5) * force * (dt / touch.mass);
        Push<Real> push;
        push.force = touch.normal * force + tangential.force;
        push.memory = tangential.memory;
        push.normal_viscous = force - normal.elastic;
        push.tangential_viscous = tangential.viscous;
        push.stored_normal = normal.stored;
        push.lost_normal_damping = -((force - normal.elastic) * rate_now * dt);
        push.lost_tangential_damping = tangential.lost_damping;
        push.lost_sliding = tangential.lost_sliding;
        push.lost_history = tangential.lost_history;
        return push;
    }
};

} // namespace tumble::contact
