#pragma once

#include "observe/frame.h"
#include "render/wall_surface.h"

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

/// Walls within a box whose faces cut them open. Metres, of the world.
namespace tumble::render {

using Segment = std::array<Eigen::Vector3d, 2>;

/// The shares of the way between two points at which it enters the box and leaves it; nothing where it stays outside.
std::optional<std::array<double, 2>> shares_within(const Eigen::AlignedBox3d& box, const Segment& way);

/// The lines along which the box' faces cut the wall, a piece a triangle.
std::vector<Segment> cut_lines(const WallSurface& surface, const observe::WallPlace& place,
                               const Eigen::AlignedBox3d& box);

} // namespace tumble::render
