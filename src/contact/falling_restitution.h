#pragma once

#include "base/pack.h"
#include "contact/material.h"

#include <numbers>

namespace tumble::contact {

/// ln of the restitution of an impact at `speed` (m/s): e_0 (v / v_0)^-p, at most e_most, where it falls with speed. p
/// = 1/4 where impacts are plastic throughout (Johnson 1985, 11.46); 1/5 is the power of 1 - e in viscoelastic ones
/// (Kuwabara and Kono 1987). Where surfaces stick, times sqrt(1 - (v_s / v)^2) (Thornton and Ning 1998): parting costs
/// the energy of an impact at v_s, and what is slower does not come back.
template <class Real> TUMBLE_INLINE Real ln_restitution_at(Real speed, const PairConstants& pair) {
    Real ln_e(pair.ln_restitution);
    if (pair.restitution_exponent > 0) {
        const Real falling = Real(pair.ln_restitution) -
                             Real(pair.restitution_exponent) * logarithm(speed / Real(pair.restitution_speed));
        const Real most(pair.ln_restitution_most);
        ln_e = select(falling > most, most, falling);
    }
    if (pair.sticking_speed > 0) {
        const Real share = Real(pair.sticking_speed) / speed;
        ln_e = ln_e + Real(0.5) * logarithm(larger(Real(1.0) - share * share, Real(1e-300)));
    }
    return ln_e;
}

/// Share of critical damping that gives that restitution: -ln e / sqrt(ln^2 e + pi^2).
template <class Real> TUMBLE_INLINE Real damping_at(Real speed, const PairConstants& pair) {
    const Real ln_e = ln_restitution_at(speed, pair);
    return -ln_e / root(ln_e * ln_e + Real(std::numbers::pi * std::numbers::pi));
}

} // namespace tumble::contact
