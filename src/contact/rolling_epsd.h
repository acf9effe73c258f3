#pragma once

#include "contact/coulomb_spring.h"
#include "contact/material.h"
#include "contact/rolling.h"

namespace tumble::contact {

/// Elastic-plastic spring-dashpot (type C of Ai et al. 2011, equations 12 to 19): a rolling spring of stiffness
/// k_r = 2.25 k_n (mu_r R*)^2, 3 in place of 2.25 for discs, that bears at most mu_r R* F_n, and a dashpot of
/// 2 eta_r sqrt(I_r k_r) that is silent while the spring gives way. I_r is that of both bodies about the contact,
/// 1 / (1 / (I_a + m_a r_a^2) + 1 / (I_b + m_b r_b^2)).
struct Epsd {
    /// `limit` N m, mu_r R* F_n; `stiffness` N/m, the normal spring's elastic force over its overlap.
    template <class Real>
    TUMBLE_INLINE static RollingPush<Real> push(const Touch<Real>& touch, const Turn<Real>& turn, Real limit,
                                                Real stiffness, const PairConstants& pair, const Memory<Real>& memory,
                                                Real dt) {
        const Real rolling_stiffness = Real(pair.rolling_stiffness) * stiffness * touch.radius * touch.radius;
        const Real damping = Real(2 * pair.rolling_damping) * root(turn.inertia * rolling_stiffness);
        const TangentialPush<Real> push =
            limited_spring(touch.normal, rolling_part(touch.normal, turn.spin), limit, rolling_stiffness, damping,
                           memory, Real(0.5) * dt / turn.inertia, dt);
        return {push.force, push.memory, push.lost_damping, push.lost_sliding, push.lost_history};
    }
};

} // namespace tumble::contact
