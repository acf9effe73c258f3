#pragma once

#include "contact/touch.h"

namespace tumble::contact {

/// What geometry tells a rolling law beside Touch.
template <class Real> struct Turn {
    Vec3<Real> spin; // rad/s, of a relative to b, half a step ago
    Real inertia;    // kg m2, of the two as they roll over each other; rolling_epsd.h
};

/// What a rolling law answers.
template <class Real> struct RollingPush {
    Vec3<Real> torque;   // N m on a; b gets the opposite
    Memory<Real> memory; // the rolling spring, rad and J
    Real lost_damping;   // J in this step, a torque times the spin at the step
    Real lost_sliding;   // J in this step, exact
    Real lost_history;
};

/// Moment of inertia (kg m2) about the contact of a body of that mass whose sphere of radius r rolls there: 7/5 m r^2
/// of a solid sphere; 3/2 m r^2 of a disc.
constexpr double sphere_rolls = 7.0 / 5, disc_rolls = 3.0 / 2;
/// The same of a solid sphere that turns about its centre.
constexpr double sphere_turns = 2.0 / 5;

/// The part of the spin that rolls: without what twists the contact about its normal.
template <class Real> TUMBLE_INLINE Vec3<Real> rolling_part(const Vec3<Real>& normal, const Vec3<Real>& spin) {
    return spin - normal * dot(spin, normal);
}

} // namespace tumble::contact
