#include "contact/material.h"

#include <cmath>
#include <numbers>

namespace tumble::contact {

namespace {

void add(const PairProperties& pair, const Additions& additions, double rolling_stiffness, PairConstants& constants) {
    if (pair.rolling_friction > 0)
        constants.rolling = additions.rolling;
    constants.rolling_friction = pair.rolling_friction;
    constants.rolling_stiffness = rolling_stiffness * pair.rolling_friction * pair.rolling_friction;
    constants.rolling_damping = pair.rolling_damping;
    constants.rolling_time = pair.rolling_time;
    constants.restitution_exponent = pair.restitution_exponent;
    constants.restitution_speed = pair.restitution_speed;
    constants.sticking_speed = pair.restitution > 0 ? pair.sticking_speed : 0;
    constants.ln_restitution = std::log(pair.restitution);
    constants.ln_restitution_most = std::log(pair.restitution_most);
    if (pair.sliding_friction != pair.friction)
        constants.sliding_speed = pair.sliding_speed;
    constants.sliding_friction = pair.sliding_friction;
    if ((additions.adhesion == AdhesionLaw::sjkr ? pair.cohesion_energy : pair.work_of_adhesion) > 0)
        constants.adhesion = additions.adhesion;
    constants.cohesion_energy = pair.cohesion_energy;
    constants.work_of_adhesion = pair.work_of_adhesion;
}

} // namespace

PairConstants derive(const Material& a, const Material& b, const PairProperties& pair, const Additions& additions,
                     double rolling_stiffness) {
    const auto normal_compliance = [](const Material& m) {
        return (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
    };
    const auto shear_compliance = [](const Material& m) {
        return 2 * (2 - m.poisson_ratio) * (1 + m.poisson_ratio) / m.youngs_modulus;
    };
    PairConstants constants;
    constants.E_eff = 1 / (normal_compliance(a) + normal_compliance(b));
    constants.G_eff = 1 / (shear_compliance(a) + shear_compliance(b));
    const double ln_e = std::log(pair.restitution);
    constants.damping = pair.restitution > 0 && pair.restitution_exponent == 0 && pair.sticking_speed == 0
                            ? -ln_e / std::sqrt(ln_e * ln_e + std::numbers::pi * std::numbers::pi)
                            : 1.0;
    constants.hertz_damping = 2 * std::sqrt(5.0 / 6.0) * constants.damping * std::sqrt(2 * constants.E_eff);
    constants.mindlin_damping = 2 * std::sqrt(5.0 / 6.0) * constants.damping * std::sqrt(8 * constants.G_eff);
    constants.friction = pair.friction;
    if (pair.contact_time > 0)
        constants.stiffness_per_mass =
            (std::numbers::pi * std::numbers::pi + (pair.restitution > 0 ? ln_e * ln_e : 0.0)) /
            (pair.contact_time * pair.contact_time);
    constants.stiffness_ratio = pair.stiffness_ratio;
    constants.damping_time = pair.damping_time;
    constants.cohesion = pair.cohesion;
    constants.normal_stiffness = pair.normal_stiffness;
    constants.tangential_stiffness = pair.tangential_stiffness;
    add(pair, additions, rolling_stiffness, constants);
    return constants;
}

} // namespace tumble::contact
