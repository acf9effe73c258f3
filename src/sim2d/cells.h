#pragma once

#include "solver/cell_grid.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::sim2d {

/// Points by the cell they stand in; neighbours stand in the 9 cells around.
class Cells : public solver::CellGrid<2> {
public:
    /// As CellGrid::sort.
    void sort(const scene::Domain& domain, const std::vector<Eigen::Vector2d>& points, double reach);

    /// One cell seen from another: where its points stand, and through which image of the periodic box.
    struct Seen {
        const int* begin;
        const int* end;
        int image; // 0..8, 4 is the box itself
    };
    /// The cells around the one that holds `point`, itself included, each image once; returns how many.
    int around(const Eigen::Vector2d& point, std::array<Seen, 9>& seen) const;
};

/// Image 4 is the box itself; its digits to base 3, x first, are -1, 0, +1 box lengths.
inline int image_index(int x, int y) {
    return (x + 1) + 3 * (y + 1);
}

} // namespace tumble::sim2d
