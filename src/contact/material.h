#pragma once

#include <string>

namespace tumble::contact {

/// Bulk properties of one material, SI.
struct Material {
    std::string name;
    double density = 0;        // kg/m3
    double youngs_modulus = 0; // Pa
    double poisson_ratio = 0;  // -
};

/// What two materials do to each other. The linear stiffnesses are read only by the linear law.
struct PairProperties {
    double restitution = 0;          // -, 0..1
    double friction = 0;             // -, Coulomb
    double normal_stiffness = 0;     // N/m, linear spring-dashpot
    double tangential_stiffness = 0; // N/m, linear spring-dashpot
    // Of discs only.
    double contact_time = 0;    // s, in place of normal_stiffness
    double stiffness_ratio = 0; // -, k_s / k_n, in place of tangential_stiffness
    double damping_time = 0;    // s, dashpot over spring, in place of restitution
    double cohesion = 0;        // N
};

/// Effective constants of a pair, derived once and used in every contact of that pair.
struct PairConstants {
    double E_eff = 0;                // Pa, 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2
    double G_eff = 0;                // Pa, 1/G* = 2(2-nu1)(1+nu1)/E1 + 2(2-nu2)(1+nu2)/E2
    double damping = 0;              // -, -beta = -ln e / sqrt(ln^2 e + pi^2), 0 (elastic) to 1 (e = 0)
    double hertz_damping = 0;        // 2 sqrt(5/6) |beta| sqrt(2 E*), Pa^0.5
    double mindlin_damping = 0;      // 2 sqrt(5/6) |beta| sqrt(8 G*), Pa^0.5
    double friction = 0;             // -
    double normal_stiffness = 0;     // N/m
    double tangential_stiffness = 0; // N/m
    double stiffness_per_mass = 0;   // 1/s2, k_n over m* where the contact time is given
    double stiffness_ratio = 0;      // -, k_s over k_n
    double damping_time = 0;         // s, dashpot over spring
    double cohesion = 0;             // N
};

/// Johnson 1985 (E*), Mindlin 1949 (G*), Tsuji et al. 1992 (beta). Restitution 0 gives damping 1. A contact that lasts
/// t_c with restitution e has k = m* (pi^2 + ln^2 e) / t_c^2, the half period of the damped oscillator; at e = 0, which
/// never parts, the undamped half period counts.
PairConstants derive(const Material& a, const Material& b, const PairProperties& pair);

} // namespace tumble::contact
