#pragma once

#include "sim2d/body_shape.h"
#include "sim2d/wall_line.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tumble::sim2d {

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

/// Discs by cell, growing as bodies are placed.
class Crowd {
public:
    /// The discs of `bodies`, and room for `more`.
    Crowd(const scene::Domain& domain, const std::vector<ShapeData>& shapes, const std::vector<Placement>& bodies,
          std::int64_t more);

    void add(const std::vector<Disc>& discs);
    [[nodiscard]] bool leaves_room_for(const std::vector<Disc>& discs) const;

private:
    /// Along periodic axes.
    [[nodiscard]] Eigen::Vector2d into_box(Eigen::Vector2d centre) const;
    [[nodiscard]] std::array<int, 2> place(const Eigen::Vector2d& centre) const;
    [[nodiscard]] std::size_t index(const std::array<int, 2>& at) const;
    [[nodiscard]] bool cell_leaves_room(const Disc& disc, std::array<int, 2> at) const;

    const scene::Domain& domain_;
    std::array<int, 2> size_{1, 1};
    std::vector<int> first_; // per cell, of its discs; -1: none
    std::vector<int> next_;  // per disc, in its cell
    std::vector<Disc> discs_;
};

} // namespace tumble::sim2d
