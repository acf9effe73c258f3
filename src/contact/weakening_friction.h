#pragma once

#include "base/pack.h"
#include "contact/material.h"

namespace tumble::contact {

/// Friction that weakens with the speed of sliding (m/s), mu_k + (mu_s - mu_k) exp(-v / v_c) (Tustin 1947, as surveyed
/// by Armstrong-Helouvry et al. 1994, equation 5).
template <class Real> TUMBLE_INLINE Real friction_at(Real speed, const PairConstants& pair) {
    return Real(pair.sliding_friction) +
           Real(pair.friction - pair.sliding_friction) * exponential(-speed / Real(pair.sliding_speed));
}

} // namespace tumble::contact
