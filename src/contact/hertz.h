#pragma once

#include "contact/material.h"
#include "contact/touch.h"

namespace tumble::contact {

/// Hertz 1881 elastic force with the damping of Tsuji et al. 1992: F = 4/3 E* a d - c v with a = sqrt(R* d) and
/// c = 2 sqrt(5/6) |beta| sqrt(2 E* a m*), so that restitution does not depend on speed. `normal_rate` is the normal
/// part of the relative velocity, m/s, negative while approaching. The stiffness passed on is a, the contact radius.
struct Hertz {
    template <class Real>
    TUMBLE_INLINE static NormalPush<Real> push(const Touch<Real>& touch, Real normal_rate, const PairConstants& pair) {
        const Real a = root(touch.radius * touch.overlap);
        const Real elastic = Real(4.0 / 3.0 * pair.E_eff) * a * touch.overlap;
        const Real c = Real(pair.hertz_damping) * root(a * touch.mass) * touch.damping_share;
        return {elastic, -(c * normal_rate), Real(0.4) * elastic * touch.overlap, a};
    }
    /// Elastic force over overlap, N/m, from the stiffness passed on.
    template <class Real> TUMBLE_INLINE static Real secant(Real a, const PairConstants& pair) {
        return Real(4.0 / 3.0 * pair.E_eff) * a;
    }
};

} // namespace tumble::contact
