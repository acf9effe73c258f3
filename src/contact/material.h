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
};

/// Johnson 1985 (E*), Mindlin 1949 (G*), Tsuji et al. 1992 (beta). Restitution 0 gives damping 1.
PairConstants derive(const Material& a, const Material& b, const PairProperties& pair);

} // namespace tumble::contact
