#pragma once

#include "contact/material.h"
#include "contact/rolling.h"

namespace tumble::contact {

/// Constant directional torque (Zhou et al. 1999; type A of Ai et al. 2011, equation 7): M = mu_r R* F_n against the
/// rolling, whatever its speed. It has no memory, so a body at rest is pushed to and fro in every step.
struct Cdt {
    /// `limit` N m, mu_r R* F_n.
    template <class Real>
    TUMBLE_INLINE static RollingPush<Real> push(const Touch<Real>& touch, const Turn<Real>& turn, Real limit, Real dt) {
        const Real none(0.0);
        const Vec3<Real> rolling = rolling_part(touch.normal, turn.spin);
        const Real speed = root(dot(rolling, rolling));
        RollingPush<Real> push{};
        push.torque = rolling * (none - limit / larger(speed, Real(1e-300)));
        const Vec3<Real> rolling_now = rolling + push.torque * (Real(0.5) * dt / turn.inertia);
        push.lost_damping = (none - dot(push.torque, rolling_now)) * dt;
        return push;
    }
};

} // namespace tumble::contact
