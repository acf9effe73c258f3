#pragma once

#include "base/problem.h"
#include "contact/material.h"

#include <vector>

/// Impacts run by the solvers, and the closed forms that they are held against.
namespace tumble::lesson {

/// What was seen between the first touch and the last.
struct Impact {
    double overlap_max = 0;                   // m
    double force_max = 0;                     // N
    double force_min = 0;                     // N, below 0 when the contact pulled
    double duration = 0;                      // s
    double restitution = 0;                   // -, speed away over speed towards
    std::vector<double> time, overlap, force; // s, m, N
};

constexpr double struck_radius = 0.1; // m, of the disc that strikes

/// A disc of that mass (kg) strikes a wall at `speed` (m/s) under the linear law. Problems: those of the solver.
/// `limit_force` true: the contact never pulls. `ahead`: m before the touch where it begins, less than a step's way.
Result<Impact> strike_disc(const contact::PairProperties& pair, double mass, double speed, double dt,
                           bool limit_force = false, double ahead = 0);

/// A sphere of that radius (m) strikes a plane of the same material under Hertz' law.
Result<Impact> strike_sphere(const contact::Material& material, const contact::PairProperties& pair, double radius,
                             double speed, double dt);

/// zeta of one contact, -ln e / sqrt(pi^2 + ln^2 e).
double damping_ratio(double restitution);

/// An elastic impact after Hertz (Johnson 1985, 11.2): deepest overlap, largest force, duration.
struct HertzImpact {
    double overlap = 0, force = 0, duration = 0; // m, N, s
};
HertzImpact hertz_impact(double E_eff, double radius, double mass, double speed);

} // namespace tumble::lesson
