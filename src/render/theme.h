#pragma once

#include "base/problem.h"

#include <Eigen/Core>
#include <string>

namespace tumble::render {

/// Colours that go together with a background, sRGB 0 to 1.
struct Theme {
    Eigen::Vector3d background = Eigen::Vector3d::Zero();
    Eigen::Vector3d text = Eigen::Vector3d::Ones();
    Eigen::Vector3d faint = Eigen::Vector3d::Ones(); // axes, frames, ticks
    Eigen::Vector3d line = Eigen::Vector3d::Ones();  // the plot's curve
    Eigen::Vector3d wall = Eigen::Vector3d::Ones();
    Eigen::Vector3d edge = Eigen::Vector3d::Ones();       // walls' edges
    Eigen::Vector3d outline = Eigen::Vector3d::Zero();    // of discs
    Eigen::Vector3d plain = Eigen::Vector3d::Ones();      // bodies without a colour of their own
    Eigen::Vector3d plain_edge = Eigen::Vector3d::Zero(); // their outlines in two dimensions
    Eigen::Vector3d arrow = Eigen::Vector3d::Ones();      // velocities
    Eigen::Vector3d chain = Eigen::Vector3d::Ones();      // forces
    float rim = 0;                                        // added where a body bends away from the eye
};

/// "dark" or "white"; Problem for another word.
Result<Theme> find_theme(const std::string& background);

} // namespace tumble::render
