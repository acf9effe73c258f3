#pragma once

#include "sim2d/world.h"

#include <Eigen/Core>
#include <vector>

namespace tumble::sim2d {

/// Where a body would stand.
struct Placement {
    int shape = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero(); // m, centre of mass
    double angle = 0;                                   // rad
};

/// The body's discs there.
std::vector<Disc> discs_of(const World& world, const Placement& body);

/// Whether any disc of the body reaches a wall as it stands now.
bool in_wall(const World& world, const std::vector<Disc>& discs);

/// Discs by cell, growing as bodies are placed.
class Crowd {
public:
    /// All discs of the world, and room for `more`.
    Crowd(const World& world, std::int64_t more);

    void add(const std::vector<Disc>& discs);
    [[nodiscard]] bool leaves_room_for(const std::vector<Disc>& discs) const;

private:
    /// Along periodic axes.
    [[nodiscard]] Eigen::Vector2d into_box(Eigen::Vector2d centre) const;
    [[nodiscard]] std::array<int, 2> place(const Eigen::Vector2d& centre) const;
    [[nodiscard]] std::size_t index(const std::array<int, 2>& at) const;
    [[nodiscard]] bool cell_leaves_room(const Disc& disc, std::array<int, 2> at) const;

    const World& world_;
    std::array<int, 2> size_{1, 1};
    std::vector<int> first_; // per cell, of its discs; -1: none
    std::vector<int> next_;  // per disc, in its cell
    std::vector<Disc> discs_;
};

} // namespace tumble::sim2d
