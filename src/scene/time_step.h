#pragma once

#include "scene/scene.h"

#include <limits>
#include <string>
#include <vector>

/// How long a step may be: what the solvers share of it. Each tells how its bodies answer a push.
namespace tumble::scene {

/// Time scales that bound the step, s; each is the smallest over all bodies and material pairs of the scene.
struct TimeStepReport {
    double step = 0;         // s, what the scene asks for
    double rayleigh = 0;     // pi R sqrt(rho/G) / (0.1631 nu + 0.8766), smallest sphere; 0 without elastic moduli
    std::string rayleigh_of; // "body cone, sphere 1 (r = 1.53 mm)"
    double hertz = 0;        // 2.87 (m*^2 / (R* E*^2 v))^0.2 at `hertz_speed`; 0 for the linear law
    std::string hertz_of;
    double hertz_speed = 0; // m/s, assumed impact speed: the fall through the scene plus wall motion
    double body_period = 0; // 2 pi sqrt(m*/k): m* felt at the contact, rotation included; k of four at once
    std::string body_of;
    double linear_period = 0; // pi sqrt(m*/k) of the linear law, 0 when it is not used
    double limit = 0;         // s, above this the run is refused: body_period / pi, less for damping; docs/bodies.md
    [[nodiscard]] bool stable() const { return step <= limit; }
};

/// The fastest impact that the scene lets expect, m/s: the fall from each fill's top to the domain's bottom on top of
/// its own velocity, plus the fastest wall; or two fills thrown at each other.
double impact_speed(const Scene& scene);

/// One side of a contact: a body at its outermost sphere or disc, or a wall.
struct ContactSide {
    std::string name;
    int material = 0;
    double mass = std::numeric_limits<double>::infinity();   // kg
    double radius = std::numeric_limits<double>::infinity(); // m, of the largest sphere or disc
    double push_mobility = 0; // 1/kg, motion of the contact point per impulse along a normal, the largest
    double full_mobility = 0; // 1/kg, the same for any direction
};

/// A sphere or disc of a body, for the Rayleigh time.
struct NamedRadius {
    std::string name;  // "body cone, sphere 1"
    double radius = 0; // m
    int material = 0;
};

/// `bodies` has a side per template, `parts` all their spheres or discs. Sources: Rayleigh time after Li, Xu and
/// Thornton 2005; Hertz time after Timoshenko and Goodier (Johnson 1985, 11.24).
TimeStepReport time_step_report(const Scene& scene, const std::vector<ContactSide>& bodies,
                                const std::vector<NamedRadius>& parts);

} // namespace tumble::scene
