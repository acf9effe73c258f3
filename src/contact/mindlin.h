#pragma once

#include "contact/coulomb_spring.h"
#include "contact/hertz.h"

namespace tumble::contact {

/// Mindlin 1949 shear stiffness without micro-slip, k = 8 G* a, as a spring with history and Coulomb's limit; damping
/// c = 2 sqrt(5/6) |beta| sqrt(k m*). `a` is the contact radius that Hertz passes on.
struct Mindlin {
    template <class Real>
    TUMBLE_INLINE static TangentialPush<Real> push(const Touch<Real>& touch, const Vec3<Real>& slip_rate, Real limit,
                                                   Real a, const PairConstants& pair, const Memory<Real>& memory,
                                                   Real dt) {
        const Real stiffness = Real(8 * pair.G_eff) * a;
        const Real damping = Real(pair.mindlin_damping) * root(a * touch.mass) * touch.damping_share;
        return coulomb_spring(touch, slip_rate, limit, stiffness, damping, memory, dt);
    }
};

} // namespace tumble::contact
