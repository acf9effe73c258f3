#pragma once

#include "observe/frame.h"

#include <Eigen/Core>

namespace tumble::observe {

/// All bodies of a frame taken as one mass. Every value is NaN for a frame without bodies.
struct BulkMotion {
    double mass = 0;                                        // kg
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();       // m, centre of mass
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();     // m/s, of the centre of mass
    Eigen::Vector3d rms_velocity = Eigen::Vector3d::Zero(); // m/s, sqrt of the mass-weighted mean square, per axis
    double kinetic_translation = 0;                         // J, sum of m v^2 / 2
    double kinetic_rotation = 0;                            // J, sum of w.I.w / 2 with the principal inertia
    double mean_speed = 0;                                  // m/s, mass-weighted
    double mean_angular_speed = 0;                          // rad/s, mass-weighted
    double circulation = 0;                                 // rad/s, see bulk_circulation in docs/measures.md
};

/// Circulation is the rigid-body part of the flow in the y-z plane: angular momentum of the body centres about the
/// bulk's centre, x component, over their moment of inertia about the same axis. Positive turns y towards z. Spin of
/// the bodies themselves is left out. In two dimensions it is the x-y plane, positive from x towards y, as angles are.
/// NaN where z is periodic (the plane then has no centre) or all bodies lie on the
/// axis.
BulkMotion bulk_motion(const Frame& frame);

} // namespace tumble::observe
