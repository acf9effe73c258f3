#pragma once

#include "scene/scene.h"
#include "sim3d/kernels.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::sim3d {

/// A few bodies far apart must not make millions of empty cells.
constexpr double cells_per_body = 4;

/// Bodies by the cell that holds their bounding sphere's centre. Cells are at least as wide as two bodies reach, so
/// neighbours stand in the 27 cells around. The longest side of the grid is the slowest index.
class Cells {
public:
    /// Sorts anew, in the room of the last time. Centres lie in the periodic box; `reach` m is the largest distance of
    /// two centres that matters.
    void sort(const scene::Domain& domain, const Lines<Bounds>& bodies, double reach);

    [[nodiscard]] int cell_of(const double* centre) const;
    [[nodiscard]] int count() const { return size_[0] * size_[1] * size_[2]; }

    /// Cells in a row, seen from another: the places of their bodies in order(), and through which image of the
    /// periodic box.
    struct Seen {
        int begin;
        int end;
        int image; // 0..26, 13 is the box itself
    };
    /// The cells around the one that holds `centre`, itself included, each image once; returns how many rows.
    int around(const double* centre, std::array<Seen, 27>& seen) const;
    /// Bodies by cell, in cell order and inside a cell in the order given.
    [[nodiscard]] const std::vector<int>& order() const { return order_; }

private:
    [[nodiscard]] std::array<int, 3> place_of(const double* centre) const;
    [[nodiscard]] int index_of(const std::array<int, 3>& place) const;

    std::array<bool, 3> periodic_{};
    std::array<int, 3> axis_{}; // axis_[0] is the longest
    Eigen::Vector3d lo_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d per_cell_ = Eigen::Vector3d::Zero(); // 1/m
    std::array<int, 3> size_{1, 1, 1};
    std::vector<int> begin_;
    std::vector<int> order_;
    std::vector<int> cell_; // per body
    std::vector<int> next_; // per cell
};

/// Image 13 is the box itself; its digits to base 3, x fastest, are -1, 0, +1 box lengths.
inline int image_index(int x, int y, int z) {
    return (x + 1) + 3 * (y + 1) + 9 * (z + 1);
}

} // namespace tumble::sim3d
