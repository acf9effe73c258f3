#pragma once

#include "discs/body_shape.h"
#include "discs/wall_line.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace tumble::discs {

/// Where a body stands or would stand.
struct Placement {
    int shape = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero(); // m, centre of mass
    double angle = 0;                                   // rad
};

/// The body's discs that can touch anything, there.
std::vector<Disc> discs_of(const std::vector<ShapeData>& shapes, const Placement& body);

/// A wall as it stands now.
struct StandingWall {
    const WallLine* line = nullptr;
    WallFrame frame;
};

/// The number of the first wall that a disc of the body reaches.
std::optional<std::size_t> wall_met(const std::vector<StandingWall>& walls, const std::vector<Disc>& discs);

} // namespace tumble::discs
