#pragma once

#include "observe/frame.h"
#include "scene/scene.h"

#include <Eigen/Geometry>

namespace tumble::run {

/// What a picture of a run must hold that has not happened yet, m: the walls wherever they will move, and all places
/// that bodies come from.
Eigen::AlignedBox3d view_box(const scene::Scene& scene, const observe::FrameLayout& layout);

} // namespace tumble::run
