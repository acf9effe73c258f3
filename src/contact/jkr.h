#pragma once

#include "contact/material.h"
#include "contact/touch.h"

#include <numbers>

namespace tumble::contact {

/// Johnson, Kendall and Roberts 1971: surfaces that stick within the area of contact, with the work of adhesion w per
/// area,
///   F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3),   d = a^2 / R* - sqrt(2 pi w a / E*).
/// A neck holds to the overlap -3 a_t^2 / R* where a_t^3 = pi w R*^2 / (8 E*); written in x = sqrt(a / a_t), F is
/// pi w R* (x^6 / 6 - x^3) and d is (x^4 - 4 x) a_t^2 / R*. The greatest pull is 3/2 pi w R*. The dashpot is that of
/// Hertz.
struct Jkr {
    /// a_t, m.
    template <class Real> TUMBLE_INLINE static Real neck(Real radius, const PairConstants& pair) {
        return cube_root(radius * radius * Real(std::numbers::pi * pair.work_of_adhesion / (8 * pair.E_eff)));
    }
    /// The greatest gap over which a neck holds, m.
    template <class Real> TUMBLE_INLINE static Real reach(Real radius, const PairConstants& pair) {
        const Real a = neck(radius, pair);
        return Real(3.0) * a * a / radius;
    }
    /// 1 where the two touch, or where they did and the gap is no wider than the `reach` of a neck, else 0. `bonded`: 1
    /// where they touched or stuck a step ago, else 0.
    template <class Real> TUMBLE_INLINE static Real holds(Real overlap, Real reach, Real bonded) {
        const Real none(0.0);
        const Real neck = select(overlap > none - reach, bonded, none);
        return select(overlap > none, Real(1.0), neck);
    }
    /// The stable one of the two x with x^4 - 4 x = D, D >= -3: (x^2 + m)^2 = 2 m (x + 1 / m)^2 where m^3 + D m = 2,
    /// whose root is Cardano's without its cancellation.
    template <class Real> TUMBLE_INLINE static Real root_of(Real D) {
        const Real third = D * Real(1.0 / 3);
        const Real q = root(larger(Real(1.0) + third * third * third, Real(0.0)));
        const Real u = cube_root(q + Real(1.0));
        const Real v = cube_root(q - Real(1.0));
        const Real m = Real(2.0) / (u * u + third + v * v);
        const Real rest = Real(4.0) * root(Real(2.0) / m) - Real(2.0) * m;
        return Real(0.5) * (root(Real(2.0) * m) + root(larger(rest, Real(0.0))));
    }

    /// As Hertz::push, for overlaps from -reach on; the energy stored is that of a contact made at overlap 0.
    template <class Real>
    TUMBLE_INLINE static NormalPush<Real> push(const Touch<Real>& touch, Real normal_rate, const PairConstants& pair) {
        const Real a_t = neck(touch.radius, pair);
        const Real x = root_of(touch.overlap * touch.radius / (a_t * a_t));
        const Real x3 = x * x * x;
        const Real elastic =
            Real(std::numbers::pi * pair.work_of_adhesion) * touch.radius * (x3 * x3 * Real(1.0 / 6) - x3);
        const Real unit = Real(pair.E_eff) * a_t * a_t * a_t * a_t * a_t / (touch.radius * touch.radius);
        const Real x4 = x3 * x;
        const Real stored =
            unit * (x4 * (Real(8.0 / 15) * x3 * x3 - Real(16.0 / 3) * x3 + Real(8.0)) + Real(energy_at_touch));
        const Real a = a_t * x * x;
        const Real c = Real(pair.hertz_damping) * root(a * touch.mass) * touch.damping_share;
        return {elastic, -(c * normal_rate), stored, a};
    }

private:
    // 4^(4/3) 24/5: what the bracket lacks at d = 0, where x^3 = 4.
    static constexpr double energy_at_touch = 4.8 * 6.3496042078727974;
};

} // namespace tumble::contact
