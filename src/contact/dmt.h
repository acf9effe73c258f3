#pragma once

#include "contact/material.h"
#include "contact/touch.h"

#include <numbers>

namespace tumble::contact {

/// Derjaguin, Muller and Toporov 1975: surfaces that attract around the contact, which keeps the shape that Hertz gives
/// it. A pull of 2 pi w R* for as long as they touch; it does not reach beyond.
struct Dmt {
    /// N.
    template <class Real> TUMBLE_INLINE static Real pull(const Touch<Real>& touch, const PairConstants& pair) {
        return Real(2 * std::numbers::pi * pair.work_of_adhesion) * touch.radius;
    }
    /// Its potential, J.
    template <class Real> TUMBLE_INLINE static Real stored(const Touch<Real>& touch, const PairConstants& pair) {
        return -(pull(touch, pair) * touch.overlap);
    }
};

} // namespace tumble::contact
