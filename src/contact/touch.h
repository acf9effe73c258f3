#pragma once

#include "base/vec3.h"

/// What geometry tells a law and what the law answers. Real is double, or a pack of eight doubles.
namespace tumble::contact {

template <class Real> struct Touch {
    Real overlap;        // m, > 0
    Vec3<Real> normal;   // unit, from b to a
    Vec3<Real> velocity; // m/s, a's surface relative to b's at the contact
    Real radius;         // m, R* = Ra Rb / (Ra + Rb); a wall leaves Ra
    Real mass;           // kg, m* of the two bodies; a wall leaves a's
    Real damping_share;  // -, 1, or 1/sqrt(n) where n contacts of one body pair share the damping
    // m* times how fast a force along the surfaces speeds up their slip: 1 + m R^2 / I of spheres, 3 of discs.
    Real slip_mobility = Real(3.5);
};

/// What a contact remembers from step to step.
template <class Real> struct Memory {
    Vec3<Real> spring; // m, tangential displacement
    Real energy;       // J, stored in that spring
};

template <class Real> struct NormalPush {
    Real elastic;   // N, along the normal, pushes when positive
    Real viscous;   // N, along the normal
    Real stored;    // J
    Real stiffness; // the law's own measure, passed on to its tangential partner
};

template <class Real> struct TangentialPush {
    Vec3<Real> force; // N on a
    Memory<Real> memory;
    Real lost_damping; // J in this step
    Real lost_sliding; // J in this step
    Real lost_history; // J in this step
};

template <class Real> struct Push {
    Vec3<Real> force; // N on a; b gets the opposite
    Memory<Real> memory;
    Real stored_normal;       // J
    Real lost_normal_damping; // J in this step
    Real lost_tangential_damping;
    Real lost_sliding;
    Real lost_history;
};

} // namespace tumble::contact
