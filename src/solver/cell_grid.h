#pragma once

#include "base/cell_width.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace tumble::solver {

/// A few points far apart must not make millions of empty cells.
constexpr double cells_per_point = 4;

/// Points by the cell they stand in. Cells are at least as wide as the reach, so neighbours stand in the cells around.
/// The longest side of the grid is the slowest index.
template <int dimensions> class CellGrid {
public:
    using Place = std::array<int, dimensions>; // of a cell, along x, y, ...

    /// Sorts anew, in the room of the last time. centre_of(k) points at the k-th point's coordinates, m, along periodic
    /// axes inside the box; `reach` m is the largest distance of two points that matters.
    template <class CentreOf>
    void sort(const scene::Domain& domain, std::size_t points, CentreOf&& centre_of, double reach) {
        lay_out(domain, points, centre_of, reach);
        begin_.assign(static_cast<std::size_t>(count()) + 1, 0);
        cell_.resize(points);
        for (std::size_t point = 0; point < points; ++point) {
            cell_[point] = cell_of(centre_of(point));
            ++begin_[static_cast<std::size_t>(cell_[point]) + 1];
        }
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        next_ = begin_;
        order_.resize(points);
        for (std::size_t point = 0; point < points; ++point)
            order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cell_[point])]++)] = static_cast<int>(point);
    }

    /// Points by cell, in cell order and inside a cell in the order given.
    [[nodiscard]] const std::vector<int>& order() const { return order_; }
    [[nodiscard]] int count() const { return std::accumulate(size_.begin(), size_.end(), 1, std::multiplies<>()); }
    [[nodiscard]] int cell_of(const double* point) const { return index_of(place_of(point)); }

protected:
    /// A cell's points in order(), and through which image of the periodic box it is seen.
    struct Seen {
        int begin = 0;
        int end = 0;
        Place image{}; // box lengths along each axis: -1, 0, +1
    };

    [[nodiscard]] Place place_of(const double* point) const {
        Place place{};
        for (std::size_t k = 0; k < dimensions; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const int p = static_cast<int>(std::floor((point[k] - lo_[axis]) * per_cell_[axis]));
            place[k] = std::clamp(p, 0, size_[k] - 1);
        }
        return place;
    }
    /// The cell at a place, which may lie one past an end; false where there is none.
    bool look(Place place, Seen& seen) const {
        seen.image = {};
        for (std::size_t k = 0; k < dimensions; ++k) {
            if (place[k] >= 0 && place[k] < size_[k])
                continue;
            if (!periodic_[k])
                return false;
            seen.image[k] = place[k] < 0 ? -1 : 1;
            place[k] -= seen.image[k] * size_[k];
        }
        const auto cell = static_cast<std::size_t>(index_of(place));
        seen.begin = begin_[cell];
        seen.end = begin_[cell + 1];
        return true;
    }
    /// From the slowest index to the fastest.
    [[nodiscard]] const Place& axes() const { return axes_; }

private:
    using Point = Eigen::Matrix<double, dimensions, 1>;

    template <class CentreOf>
    void lay_out(const scene::Domain& domain, std::size_t points, CentreOf&& centre_of, double reach) {
        Point lo = domain.box.lo.template head<dimensions>();
        Point hi = domain.box.hi.template head<dimensions>();
        for (std::size_t k = 0; k < dimensions; ++k) {
            periodic_[k] = domain.periodic[k];
            if (periodic_[k] || points == 0)
                continue;
            const auto axis = static_cast<Eigen::Index>(k);
            lo[axis] = hi[axis] = centre_of(0)[k];
            for (std::size_t point = 0; point < points; ++point) {
                lo[axis] = std::min(lo[axis], centre_of(point)[k]);
                hi[axis] = std::max(hi[axis], centre_of(point)[k]);
            }
        }
        const Point length = (hi - lo).cwiseMax(std::max(reach, 1e-12));
        const double width = cell_width_for(length, reach, cells_per_point * static_cast<double>(points) + 64);
        for (std::size_t k = 0; k < dimensions; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            size_[k] = std::max(1, static_cast<int>(std::floor(length[axis] / width)));
            per_cell_[axis] = size_[k] / length[axis];
        }
        lo_ = lo;
        std::iota(axes_.begin(), axes_.end(), 0);
        std::stable_sort(axes_.begin(), axes_.end(), [&](int a, int b) {
            return size_[static_cast<std::size_t>(a)] > size_[static_cast<std::size_t>(b)];
        });
    }

    [[nodiscard]] int index_of(const Place& place) const {
        int index = 0;
        for (const int axis : axes_)
            index = index * size_[static_cast<std::size_t>(axis)] + place[static_cast<std::size_t>(axis)];
        return index;
    }

    std::array<bool, dimensions> periodic_{};
    Place size_{};
    Place axes_{};
    Point lo_ = Point::Zero();
    Point per_cell_ = Point::Zero(); // 1/m
    std::vector<int> begin_;
    std::vector<int> order_;
    std::vector<int> cell_; // per point
    std::vector<int> next_; // per cell
};

} // namespace tumble::solver
