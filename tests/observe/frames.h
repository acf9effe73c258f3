#pragma once

#include "../folder.h"
#include "observe/frame.h"

#include <cmath>
#include <string>

/// Frames built by hand.
namespace tumble::test {

using Eigen::Vector3d;

inline observe::FrameShape ball(double radius, double mass) {
    observe::FrameShape shape;
    shape.name = "ball";
    shape.mass = mass;
    shape.inertia = Vector3d::Constant(0.4 * mass * radius * radius);
    shape.centres = {Vector3d::Zero()};
    shape.radii = {radius};
    return shape;
}

inline std::shared_ptr<observe::FrameLayout> open_layout(const observe::FrameShape& shape) {
    auto layout = std::make_shared<observe::FrameLayout>();
    layout->title = "made by hand";
    layout->shapes = {shape};
    layout->domain_lo = Vector3d(-1, -1, -1);
    layout->domain_hi = Vector3d(1, 1, 1);
    layout->periodic = {true, false, false};
    return layout;
}

inline void add_body(observe::Frame& frame, const Vector3d& position, const Vector3d& velocity = Vector3d::Zero(),
                     const Vector3d& spin = Vector3d::Zero()) {
    frame.id.push_back(static_cast<std::int64_t>(frame.id.size()));
    frame.shape.push_back(0);
    frame.position.push_back(position);
    frame.orientation.push_back(Eigen::Quaterniond::Identity());
    frame.velocity.push_back(velocity);
    frame.angular_velocity.push_back(spin);
}

} // namespace tumble::test
