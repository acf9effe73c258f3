#pragma once

#include "contact/additions.h"

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
    // Beyond the plain law; docs/laws.md.
    double rolling_friction = 0;     // -, mu_r
    double rolling_damping = 0.3;    // -, eta_r, share of the critical; EPSD
    double rolling_time = 0;         // s, by which mu_r grows per rad/s of rolling, beside what `rolling` does
    double restitution_exponent = 0; // -, p: restitution (v / restitution_speed)^-p
    double restitution_speed = 0;    // m/s
    double restitution_most = 1;     // -
    double sticking_speed = 0;       // m/s, of the fastest impact that does not come back
    double sliding_friction = 0;     // -, what friction falls to in fast sliding; only where sliding_speed > 0
    double sliding_speed = 0;        // m/s
    double cohesion_energy = 0;      // J/m3, SJKR
    double work_of_adhesion = 0;     // J/m2, JKR and DMT
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
    // Beyond the plain law.
    RollingLaw rolling = RollingLaw::none;
    double rolling_friction = 0;     // -
    double rolling_stiffness = 0;    // -, k_r over k_n R*^2
    double rolling_damping = 0;      // -
    double rolling_time = 0;         // s
    double restitution_exponent = 0; // -
    double restitution_speed = 0;    // m/s
    double sticking_speed = 0;       // m/s
    double ln_restitution = 0;       // at restitution_speed
    double ln_restitution_most = 0;
    double sliding_friction = 0; // -
    double sliding_speed = 0;    // m/s, 0: friction does not fall
    AdhesionLaw adhesion = AdhesionLaw::none;
    double cohesion_energy = 0;  // J/m3
    double work_of_adhesion = 0; // J/m2

    /// Nothing is added: Law and FullLaw are the same.
    [[nodiscard]] bool plain() const {
        return rolling == RollingLaw::none && rolling_time == 0 && !by_impact_speed() && sliding_speed == 0 &&
               adhesion == AdhesionLaw::none;
    }
    /// Restitution depends on the speed of the impact: the law scales the dashpots itself.
    [[nodiscard]] bool by_impact_speed() const { return restitution_exponent > 0 || sticking_speed > 0; }
};

/// The prefactor of EPSD's rolling stiffness (Ai et al. 2011, after Jiang et al. 2005 for discs).
constexpr double rolling_stiffness_of_spheres = 2.25, rolling_stiffness_of_discs = 3;

/// Johnson 1985 (E*), Mindlin 1949 (G*), Tsuji et al. 1992 (beta). Restitution 0 gives damping 1, and so does one that
/// depends on speed: the law then scales the dashpots itself. An addition whose parameter is 0 is none. A contact that
/// lasts t_c with restitution e has k = m* (pi^2 + ln^2 e) / t_c^2, the half period of the damped oscillator; at e = 0,
/// which never parts, the undamped half period counts.
PairConstants derive(const Material& a, const Material& b, const PairProperties& pair, const Additions& additions = {},
                     double rolling_stiffness = rolling_stiffness_of_spheres);

} // namespace tumble::contact
