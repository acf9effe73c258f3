#include "sim2d/cells.h"

#include "base/cell_width.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tumble::sim2d {

using Eigen::Vector2d;

void Cells::sort(const scene::Domain& domain, const std::vector<Vector2d>& points, double reach) {
    periodic_ = {domain.periodic[0], domain.periodic[1]};
    Vector2d lo = domain.box.lo.head<2>();
    Vector2d hi = domain.box.hi.head<2>();
    for (int k = 0; k < 2; ++k) {
        if (periodic_[static_cast<std::size_t>(k)] || points.empty())
            continue;
        lo[k] = hi[k] = points.front()[k];
        for (const Vector2d& point : points) {
            lo[k] = std::min(lo[k], point[k]);
            hi[k] = std::max(hi[k], point[k]);
        }
    }
    const Vector2d length = (hi - lo).cwiseMax(std::max(reach, 1e-12));
    const double width = cell_width_for(length, reach, cells_per_point * static_cast<double>(points.size()) + 64);
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        size_[at] = std::max(1, static_cast<int>(std::floor(length[k] / width)));
        per_cell_[k] = size_[at] / length[k];
    }
    lo_ = lo;
    slow_ = size_[0] >= size_[1] ? 0 : 1;

    const auto cells = static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
    begin_.assign(cells + 1, 0);
    cell_.resize(points.size());
    for (std::size_t point = 0; point < points.size(); ++point) {
        const std::size_t cell = index_of(place_of(points[point]));
        cell_[point] = static_cast<int>(cell);
        ++begin_[cell + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    next_ = begin_;
    order_.resize(points.size());
    for (std::size_t point = 0; point < points.size(); ++point)
        order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cell_[point])]++)] = static_cast<int>(point);
}

std::array<int, 2> Cells::place_of(const Vector2d& point) const {
    std::array<int, 2> place{};
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int p = static_cast<int>(std::floor((point[k] - lo_[k]) * per_cell_[k]));
        place[at] = std::clamp(p, 0, size_[at] - 1);
    }
    return place;
}

std::size_t Cells::index_of(const std::array<int, 2>& place) const {
    const std::size_t fast = 1 - slow_;
    return static_cast<std::size_t>(place[slow_]) * static_cast<std::size_t>(size_[fast]) +
           static_cast<std::size_t>(place[fast]);
}

int Cells::around(const Vector2d& point, std::array<Seen, 9>& seen) const {
    const std::array<int, 2> home = place_of(point);
    int n = 0;
    for (int code = 0; code < 9; ++code) {
        std::array<int, 2> place{home[0] + code % 3 - 1, home[1] + code / 3 - 1};
        std::array<int, 2> wraps{};
        bool exists = true;
        for (std::size_t k = 0; k < 2; ++k) {
            if (place[k] >= 0 && place[k] < size_[k])
                continue;
            exists = exists && periodic_[k];
            wraps[k] = place[k] < 0 ? -1 : 1;
            place[k] -= wraps[k] * size_[k];
        }
        if (!exists)
            continue;
        const std::size_t cell = index_of(place);
        seen[static_cast<std::size_t>(n++)] = {order_.data() + begin_[cell], order_.data() + begin_[cell + 1],
                                               image_index(wraps[0], wraps[1])};
    }
    return n;
}

} // namespace tumble::sim2d
