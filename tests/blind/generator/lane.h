#pragma once

#include "ball.h"

namespace blind {

/// The generator's own physics of a ball that is thrown along a lane: it slides, then rolls, then slows down. One
/// dimension; null values are those of the baseline.
struct Lane {
    double radius = 0;        // m
    double mass = 0;          // kg
    double modulus = 0;       // Pa, effective, as a Ball has it
    double gravity = 9.81;    // m/s2
    double slope = 0;         // rad, falling towards +x
    double friction = 0;      // of slow sliding
    double fast_friction = 0; // of fast sliding: mu = fast + (slow - fast) exp(-slip / slip_speed)
    double slip_speed = 0.1;  // m/s
    // Listed effects.
    double rolling = 0;      // mu_r of constant torque
    double rolling_time = 0; // s, mu_r over spin
    double linear = 0;       // N s/m
    double quadratic = 0;    // N s2/m2
    double squeeze = 0;      // m/s2, what holds a slider down beside its weight
    // Effects that no library has.
    double hollow = 0; // 1/m, the lane rises on both sides: slope - hollow x
    double patch = 0;  // share of friction lost within 0.3 m of the start
    double shakes = 0; // m/s2, the ground's upright acceleration, at 11 Hz
    double film = 0;   // s/m, friction that grows with the speed of sliding
    double wind = 0;   // m/s, along +x, in a drag of 0.02 N s2/m2 that the scene leaves out, less still air's
};

/// Coefficient of friction at that speed of sliding, m/s.
double friction_at(const Lane& lane, double slip);

/// Where the ball was until `duration`, let go at 0 with that speed (m/s, towards +x); `surface` is its spin times its
/// radius, 0 without spin. Runge and Kutta's fourth order between the events: sliding ends, the ball stops. The ball
/// has sunk in by what Hertz' law makes of its weight, and turns on an arm that is so much shorter.
Path path_along(const Lane& lane, double speed, double surface, double duration);

/// Where a body that cannot roll was until `duration`, let go at rest at 0. The same method; radius, modulus and
/// rolling do not count.
Path path_down(const Lane& lane, double duration);

/// How fast a tripod turns about the vertical, without sign, let go at 0 with that spin (rad/s): feet of `foot` (m,
/// radius) on a circle of `reach`.
Path spin_of(const Lane& lane, double spin, double foot, double reach, double duration);

} // namespace blind
