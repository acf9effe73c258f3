#pragma once

#include "scene/scene.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::sim2d {

/// Points by the cell they stand in. Cells are at least as wide as the reach, so neighbours stand in the 9 cells
/// around. The longer side of the grid is the slower index.
class Cells {
public:
    /// Sorts anew, in the room of the last time. `points` in m, along periodic axes inside the box; `reach` m is the
    /// largest distance of two points that matters.
    void sort(const scene::Domain& domain, const std::vector<Eigen::Vector2d>& points, double reach);

    /// One cell seen from another: where its points stand, and through which image of the periodic box.
    struct Seen {
        const int* begin;
        const int* end;
        int image; // 0..8, 4 is the box itself
    };
    /// The cells around the one that holds `point`, itself included, each image once; returns how many.
    int around(const Eigen::Vector2d& point, std::array<Seen, 9>& seen) const;
    /// Points by cell, in cell order and inside a cell in the order given.
    [[nodiscard]] const std::vector<int>& order() const { return order_; }

private:
    [[nodiscard]] std::array<int, 2> place_of(const Eigen::Vector2d& point) const;
    [[nodiscard]] std::size_t index_of(const std::array<int, 2>& place) const;

    std::array<bool, 2> periodic_{};
    std::size_t slow_ = 0; // axis
    Eigen::Vector2d lo_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d per_cell_ = Eigen::Vector2d::Zero(); // 1/m
    std::array<int, 2> size_{1, 1};
    std::vector<int> begin_;
    std::vector<int> order_;
    std::vector<int> cell_; // per point
    std::vector<int> next_; // per cell
};

/// Image 4 is the box itself; its digits to base 3, x first, are -1, 0, +1 box lengths.
inline int image_index(int x, int y) {
    return (x + 1) + 3 * (y + 1);
}

} // namespace tumble::sim2d
