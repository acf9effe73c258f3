#pragma once

#include "contact/material.h"
#include "contact/rolling.h"

namespace tumble::contact {

/// Viscous rolling resistance (Brilliantov and Poeschel 1998; type B of Ai et al. 2011): M = tau R* F_n w, in
/// proportion to the rolling w, as if mu_r were tau w. Taken at the spin of the step itself, half a kick later, so that
/// no step is too long for it: a spin never grows. A sphere that is free to turn has 2/7 of the inertia it rolls with.
struct ViscousRolling {
    /// `per_time` N m s, tau R* F_n.
    template <class Real>
    TUMBLE_INLINE static RollingPush<Real> push(const Touch<Real>& touch, const Turn<Real>& turn, Real per_time,
                                                Real dt) {
        const Real none(0.0);
        const Vec3<Real> rolling = rolling_part(touch.normal, turn.spin);
        const Real half_kick = Real(0.5) * dt / turn.inertia;
        RollingPush<Real> push{};
        push.torque =
            rolling * (none - per_time / (Real(1.0) + Real(sphere_rolls / sphere_turns) * per_time * half_kick));
        const Vec3<Real> rolling_now = rolling + push.torque * half_kick;
        push.lost_damping = (none - dot(push.torque, rolling_now)) * dt;
        return push;
    }
};

} // namespace tumble::contact
