#pragma once

#include <numbers>

namespace tumble::contact {

/// Still air, or another medium that bodies move through without disturbing each other's share of it.
struct Air {
    double density = 0;          // kg/m3
    double viscosity = 0;        // Pa s
    double drag_coefficient = 0; // -

    [[nodiscard]] bool there() const { return viscosity > 0 || (density > 0 && drag_coefficient > 0); }
};

/// Drag of one body: a force (linear + quadratic |v|) v against its motion.
struct AirDrag {
    double linear = 0;    // N s/m
    double quadratic = 0; // N s2/m2
};

/// Stokes 1851, 3 pi mu d v, and Newton's rho C_d / 2 (pi d^2 / 4) v^2, of a sphere of diameter d (m). Their sum.
inline AirDrag drag_of_sphere(const Air& air, double d) {
    return {3 * std::numbers::pi * air.viscosity * d,
            0.125 * std::numbers::pi * air.density * air.drag_coefficient * d * d};
}

/// Newton's rho C_d / 2 (d l) v^2 of a cylinder across its axis, d thick and l long (m). A linear part does not exist:
/// Stokes' paradox.
inline AirDrag drag_of_disc(const Air& air, double d, double l) {
    return {0, 0.5 * air.density * air.drag_coefficient * d * l};
}

} // namespace tumble::contact
