#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace tumble::solver {

/// A place where a body touched another body, or a wall, in the last step taken. In two dimensions every z is 0.
struct ContactPush {
    std::int64_t a = 0;                               // id
    std::int64_t b = -1;                              // id of the other body; -1: it is a wall
    int wall = -1;                                    // of scene.walls; -1: it is a body
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  // m, in the middle of the overlap, where a is
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // unit, towards a
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // N, on a
};

} // namespace tumble::solver
