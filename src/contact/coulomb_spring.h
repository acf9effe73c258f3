#pragma once

#include "contact/touch.h"

namespace tumble::contact {

/// A spring that is stretched across the normal by `rate`, its dashpot, and a limit of what the spring may bear, the
/// form that LIGGGHTS calls "history": the stretch is projected onto the present contact plane and alone decides
/// whether the contact gives way; while it does the dashpot is silent and the spring is cut back to the limit.
///   rate       m/s or rad/s, across the normal, half a step ago
///   limit      N or N m
///   stiffness  per stretch;  damping  per rate
///   half_kick  change of rate that one unit of force makes in half a step: losses are taken with the rate at the step
///              itself, so that they are second order in dt for one contact between spheres
template <class Real>
TUMBLE_INLINE TangentialPush<Real> limited_spring(const Vec3<Real>& normal, const Vec3<Real>& rate, Real limit,
                                                  Real stiffness, Real damping, const Memory<Real>& memory,
                                                  Real half_kick, Real dt) {
    const Real none(0.0);
    const Vec3<Real> kept = memory.spring - normal * dot(memory.spring, normal);
    const Vec3<Real> step = rate * dt;
    const Vec3<Real> trial = kept + (step - normal * dot(step, normal));
    const Real stretch = root(dot(trial, trial));
    const Real spring_force = stiffness * stretch;
    const auto slides = spring_force > limit;
    const Real cut = select(slides, limit / larger(spring_force, Real(1e-300)), Real(1.0));

    TangentialPush<Real> push;
    push.memory.spring = trial * cut;
    const Real c = select(slides, none, damping);
    push.force = (push.memory.spring * stiffness + rate * c) * Real(-1.0);

    const Vec3<Real> rate_now = rate + push.force * half_kick;
    push.lost_damping = c * dot(rate, rate_now) * dt;
    const Real after = cut * stretch;
    // What is cut off slid under the mean of the forces before and after: second order also where the limit moves.
    push.lost_sliding = Real(0.5) * stiffness * (dot(kept, trial) + after * stretch) * (Real(1.0) - cut);
    push.memory.energy = Real(0.5) * stiffness * after * after;
    push.lost_history = memory.energy - Real(0.5) * stiffness * dot(kept, kept);
    return push;
}

/// Tangential spring and dashpot under Coulomb's limit (N, friction * |normal force|).
template <class Real>
TUMBLE_INLINE TangentialPush<Real> coulomb_spring(const Touch<Real>& touch, const Vec3<Real>& slip_rate, Real limit,
                                                  Real stiffness, Real damping, const Memory<Real>& memory, Real dt) {
    const Real half_kick = Real(0.5) * touch.slip_mobility * (dt / touch.mass);
    return limited_spring(touch.normal, slip_rate, limit, stiffness, damping, memory, half_kick, dt);
}

} // namespace tumble::contact
