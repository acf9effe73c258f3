#pragma once

#include "contact/touch.h"

namespace tumble::contact {

/// Tangential spring and dashpot under Coulomb's limit, the form that LIGGGHTS calls "tangential history": the spring
/// is stretched by the slip, projected onto the present contact plane, and alone decides whether the contact slides;
/// while it slides the dashpot is silent and the spring is cut back to the limit.
///   slip_rate  m/s, tangential part of the relative velocity, half a step ago
///   limit      N, friction * |normal force|
///   stiffness  N/m;  damping  N s/m;  dt  s
/// Losses are taken with the velocity at the step itself, estimated with the mass that a sphere shows tangentially,
/// 2/7 of m*, so that they are second order in dt for one contact between spheres.
template <class Real>
TUMBLE_INLINE TangentialPush<Real> coulomb_spring(const Touch<Real>& touch, const Vec3<Real>& slip_rate, Real limit,
                                                  Real stiffness, Real damping, const Memory<Real>& memory, Real dt) {
    const Real none(0.0);
    const Vec3<Real> kept = memory.spring - touch.normal * dot(memory.spring, touch.normal);
    const Vec3<Real> step = slip_rate * dt;
    const Vec3<Real> trial = kept + (step - touch.normal * dot(step, touch.normal));
    const Real stretch = root(dot(trial, trial));
    const Real spring_force = stiffness * stretch;
    const auto slides = spring_force > limit;
    const Real cut = select(slides, limit / larger(spring_force, Real(1e-300)), Real(1.0));

    TangentialPush<Real> push;
    push.memory.spring = trial * cut;
    const Real c = select(slides, none, damping);
    push.force = (push.memory.spring * stiffness + slip_rate * c) * Real(-1.0);

    const Real half_kick = Real(0.5 * 7.0 / 2.0) * (dt / touch.mass);
    const Vec3<Real> rate_now = slip_rate + push.force * half_kick;
    push.lost_damping = c * dot(slip_rate, rate_now) * dt;
    const Real after = cut * stretch;
    // What is cut off slid under the mean of the forces before and after: second order also where the limit moves.
    push.lost_sliding = Real(0.5) * stiffness * (dot(kept, trial) + after * stretch) * (Real(1.0) - cut);
    push.memory.energy = Real(0.5) * stiffness * after * after;
    push.lost_history = memory.energy - Real(0.5) * stiffness * dot(kept, kept);
    return push;
}

} // namespace tumble::contact
