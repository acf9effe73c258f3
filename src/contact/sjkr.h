#pragma once

#include "contact/material.h"
#include "contact/touch.h"

#include <numbers>

namespace tumble::contact {

/// "Simplified JKR" of LIGGGHTS: a pull k A, with k in J/m3 and A the area of the circle in which the two spheres
/// intersect, here 2 pi R* d, which is that area to first order in d / R*.
struct Sjkr {
    /// N.
    template <class Real> TUMBLE_INLINE static Real pull(const Touch<Real>& touch, const PairConstants& pair) {
        return Real(2 * std::numbers::pi * pair.cohesion_energy) * touch.radius * touch.overlap;
    }
    /// Its potential, J.
    template <class Real> TUMBLE_INLINE static Real stored(const Touch<Real>& touch, const PairConstants& pair) {
        return Real(-0.5) * pull(touch, pair) * touch.overlap;
    }
};

} // namespace tumble::contact
