#pragma once

#include "contact/coulomb_spring.h"
#include "contact/material.h"
#include "contact/touch.h"

namespace tumble::contact {

/// Linear spring-dashpot: F = k d - c v. Cundall and Strack 1979 take c in proportion to k; here c = 2 |beta| sqrt(k
/// m*), the damped oscillator's, so that restitution is the given one at every speed.
struct LinearNormal {
    template <class Real>
    TUMBLE_INLINE static NormalPush<Real> push(const Touch<Real>& touch, Real normal_rate, const PairConstants& pair) {
        const Real k = Real(pair.normal_stiffness);
        const Real elastic = k * touch.overlap;
        const Real c = Real(2 * pair.damping) * root(k * touch.mass) * touch.damping_share;
        return {elastic, -(c * normal_rate), Real(0.5) * elastic * touch.overlap, k};
    }
    /// Elastic force over overlap, N/m, from the stiffness passed on.
    template <class Real> TUMBLE_INLINE static Real secant(Real k, const PairConstants&) { return k; }
};

/// The tangential twin of LinearNormal, with history and Coulomb's limit.
struct LinearTangential {
    template <class Real>
    TUMBLE_INLINE static TangentialPush<Real> push(const Touch<Real>& touch, const Vec3<Real>& slip_rate, Real limit,
                                                   Real, const PairConstants& pair, const Memory<Real>& memory,
                                                   Real dt) {
        const Real k = Real(pair.tangential_stiffness);
        const Real damping = Real(2 * pair.damping) * root(k * touch.mass) * touch.damping_share;
        return coulomb_spring(touch, slip_rate, limit, k, damping, memory, dt);
    }
};

/// Frictionless.
struct NoTangential {
    template <class Real>
    TUMBLE_INLINE static TangentialPush<Real> push(const Touch<Real>&, const Vec3<Real>&, Real, Real,
                                                   const PairConstants&, const Memory<Real>&, Real) {
        const Real none(0.0);
        return {{none, none, none}, {{none, none, none}, none}, none, none, none};
    }
};

} // namespace tumble::contact
