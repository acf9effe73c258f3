#pragma once

#include "sim3d/kernels.h"

#include <Eigen/Core>

namespace tumble::sim3d {

/// What one touch with a wall remembers; it belongs to the feature touched.
struct WallMemory {
    int feature = 0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // wall's frame, a step ago
    MemoryLanes lanes{};
};

} // namespace tumble::sim3d
