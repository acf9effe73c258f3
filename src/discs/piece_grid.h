#pragma once

#include "scene/outline.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::discs {

/// Which pieces of a wall may lie near a point: cells over the wall's bounds, each with the pieces whose bounds meet
/// it.
class PieceGrid {
public:
    PieceGrid() = default;
    explicit PieceGrid(const std::vector<scene::OutlinePiece>& pieces);

    /// Pieces whose bounds may be nearer than `reach` (m) to the point, ascending, each once; `out` is emptied first.
    void near(const Eigen::Vector2d& point, double reach, std::vector<int>& out) const;

private:
    [[nodiscard]] std::array<int, 2> place_of(const Eigen::Vector2d& point) const;

    scene::Rectangle bounds_;
    Eigen::Vector2d per_cell_ = Eigen::Vector2d::Zero(); // 1/m
    std::array<int, 2> size_{1, 1};
    std::vector<std::vector<int>> cells_;
};

} // namespace tumble::discs
