#pragma once

#include "scene/scene.h"
#include "sim3d/solver.h"

#include <string>
#include <vector>

namespace tumble::sim3d {

/// Time scales that bound the step, s; each is the smallest over all bodies and material pairs of the scene.
struct TimeStepReport {
    double step = 0;         // s, what the scene asks for
    double rayleigh = 0;     // pi R sqrt(rho/G) / (0.1631 nu + 0.8766), smallest sphere
    std::string rayleigh_of; // "body cone, sphere 1 (r = 1.53 mm)"
    double hertz = 0;        // 2.87 (m*^2 / (R* E*^2 v))^0.2 at `hertz_speed`
    std::string hertz_of;
    double hertz_speed = 0; // m/s, assumed impact speed: the fall through the scene plus wall motion
    double body_period = 0; // 2 pi sqrt(m*/k): m* felt at the contact, rotation included; k of four at once
    std::string body_of;
    double linear_period = 0; // pi sqrt(m*/k) of the linear law, 0 when it is not used
    double limit = 0;         // s, above this the run is refused: body_period / pi, less for damping; docs/bodies.md
    [[nodiscard]] bool stable() const { return step <= limit; }
};

/// Sources: Rayleigh time after Li, Xu and Thornton 2005; Hertz time after Timoshenko and Goodier (Johnson
/// 1985, 11.24).
TimeStepReport time_step_report(const scene::Scene& scene, const std::vector<BodyShape>& shapes);

} // namespace tumble::sim3d
