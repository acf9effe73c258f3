#pragma once

#include "base/pack.h"
#include "contact/material.h"

#include <numbers>

namespace tumble::contact {

/// Share of critical damping that gives the restitution e(v) = e_0 (v / v_0)^-p, at most e_most, of an impact at
/// `speed` (m/s): -ln e / sqrt(ln^2 e + pi^2). p = 1/4 where impacts are plastic throughout (Johnson 1985, 11.46); 1/5
/// is the power of 1 - e in viscoelastic ones (Kuwabara and Kono 1987).
template <class Real> TUMBLE_INLINE Real damping_at(Real speed, const PairConstants& pair) {
    const Real falling =
        Real(pair.ln_restitution) - Real(pair.restitution_exponent) * logarithm(speed / Real(pair.restitution_speed));
    const Real most(pair.ln_restitution_most);
    const Real ln_e = select(falling > most, most, falling);
    return -ln_e / root(ln_e * ln_e + Real(std::numbers::pi * std::numbers::pi));
}

} // namespace tumble::contact
