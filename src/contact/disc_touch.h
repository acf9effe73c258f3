#pragma once

#include "base/pack.h"

/// What geometry tells a law of two discs X and Y and what the law answers, in the signs of the thesis' section 3.2: e
/// points from X to Y, t is e turned clockwise. Real is double, or a pack of eight doubles.
namespace tumble::contact {

template <class Real> struct DiscTouch {
    Real overlap;     // m, > 0
    Real normal_rate; // m/s, n' of (3.21), positive while the two approach
    Real shear_rate;  // m/s, s' of (3.22)
    Real radius;      // m, R* = Rx Ry / (Rx + Ry); a wall leaves Rx
    Real mass;        // kg, m* of the two bodies; a wall leaves X's
};

/// What a contact remembers from step to step: how its shear spring stands. The tangent turns with the contact, so a
/// number is enough, and it is the same seen from X and from Y. CundallStrack keeps the spring's force, HertzDiscs how
/// far it is stretched; each writes and reads it by that name, and whoever only keeps it need not know which it is.
template <class Real> struct DiscMemory {
    Real kept;   // by the law, in its own unit
    Real energy; // J, stored in the shear spring

    TUMBLE_INLINE static DiscMemory of_force(Real force, Real energy) { return {force, energy}; }
    TUMBLE_INLINE static DiscMemory of_stretch(Real stretch, Real energy) { return {stretch, energy}; }
    TUMBLE_INLINE Real force() const { return kept; }   // N, F_s without its dashpot
    TUMBLE_INLINE Real stretch() const { return kept; } // m
};

/// Forces on Y; X gets the opposite. Both get the moment shear * (distance from their centre to the contact).
template <class Real> struct DiscPush {
    Real normal; // N along e, pushes the two apart when positive
    Real shear;  // N along t
    DiscMemory<Real> memory;
    Real normal_viscous; // N, the dashpots' parts of the forces
    Real shear_viscous;
    Real stored_normal;       // J
    Real lost_normal_damping; // J in this step
    Real lost_shear_damping;
    Real lost_sliding;
    Real lost_history;
};

/// As book_ahead of law.h: by how much more than this contact changes n' and s' until the step, m/s.
template <class Real>
TUMBLE_INLINE void book_ahead(DiscPush<Real>& push, Real normal_ahead, Real shear_ahead, Real dt) {
    push.lost_normal_damping = push.lost_normal_damping + push.normal_viscous * normal_ahead * dt;
    push.lost_shear_damping = push.lost_shear_damping + push.shear_viscous * shear_ahead * dt;
}

} // namespace tumble::contact
