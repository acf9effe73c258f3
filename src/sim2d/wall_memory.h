#pragma once

#include "sim2d/kernels.h"

#include <Eigen/Core>

namespace tumble::sim2d {

/// What one touch with a wall remembers; it belongs to the feature touched.
struct WallMemory {
    int feature = 0;
    Eigen::Vector2d normal = Eigen::Vector2d::Zero(); // wall's frame, a step ago
    Memory memory{};
};

} // namespace tumble::sim2d
