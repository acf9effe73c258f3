#pragma once

#include "sim3d/kernels.h"
#include "solver/cell_grid.h"

#include <array>

namespace tumble::sim3d {

/// Bodies by the cell that holds their bounding sphere's centre; neighbours stand in the 27 cells around.
class Cells : public solver::CellGrid<3> {
public:
    /// As CellGrid::sort, by the bounds' centres.
    void sort(const scene::Domain& domain, const Lines<Bounds>& bodies, double reach);

    /// Cells in a row, seen from another: the places of their bodies in order(), and through which image of the
    /// periodic box.
    struct Seen {
        int begin;
        int end;
        int image; // 0..26, 13 is the box itself
    };
    /// The cells around the one that holds `centre`, itself included, each image once; returns how many rows.
    int around(const double* centre, std::array<Seen, 27>& seen) const;
};

/// Image 13 is the box itself; its digits to base 3, x fastest, are -1, 0, +1 box lengths.
inline int image_index(int x, int y, int z) {
    return (x + 1) + 3 * (y + 1) + 9 * (z + 1);
}

} // namespace tumble::sim3d
