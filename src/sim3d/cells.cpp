#include "sim3d/cells.h"

#include "base/cell_width.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tumble::sim3d {

void Cells::sort(const scene::Domain& domain, const Lines<Bounds>& bodies, double reach) {
    periodic_ = domain.periodic;
    Eigen::Vector3d lo = domain.box.lo;
    Eigen::Vector3d hi = domain.box.hi;
    for (int k = 0; k < 3; ++k) {
        if (periodic_[static_cast<std::size_t>(k)] || bodies.empty())
            continue;
        lo[k] = hi[k] = bodies.front().centre[k];
        for (const Bounds& body : bodies) {
            lo[k] = std::min(lo[k], body.centre[k]);
            hi[k] = std::max(hi[k], body.centre[k]);
        }
    }
    const Eigen::Vector3d length = (hi - lo).cwiseMax(reach);
    const double width = cell_width_for(length, reach, cells_per_body * static_cast<double>(bodies.size()) + 64);
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        size_[at] = std::max(1, static_cast<int>(std::floor(length[k] / width)));
        per_cell_[k] = size_[at] / length[k];
    }
    lo_ = lo;
    std::iota(axis_.begin(), axis_.end(), 0);
    std::stable_sort(axis_.begin(), axis_.end(), [&](int a, int b) {
        return size_[static_cast<std::size_t>(a)] > size_[static_cast<std::size_t>(b)];
    });

    begin_.assign(static_cast<std::size_t>(count()) + 1, 0);
    cell_.resize(bodies.size());
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        cell_[body] = cell_of(bodies[body].centre);
        ++begin_[static_cast<std::size_t>(cell_[body]) + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    next_ = begin_;
    order_.resize(bodies.size());
    for (std::size_t body = 0; body < bodies.size(); ++body)
        order_[static_cast<std::size_t>(next_[static_cast<std::size_t>(cell_[body])]++)] = static_cast<int>(body);
}

std::array<int, 3> Cells::place_of(const double* centre) const {
    std::array<int, 3> place{};
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int p = static_cast<int>(std::floor((centre[k] - lo_[k]) * per_cell_[k]));
        place[at] = std::clamp(p, 0, size_[at] - 1);
    }
    return place;
}

int Cells::index_of(const std::array<int, 3>& place) const {
    const auto slow = static_cast<std::size_t>(axis_[0]);
    const auto mid = static_cast<std::size_t>(axis_[1]);
    const auto fast = static_cast<std::size_t>(axis_[2]);
    return (place[slow] * size_[mid] + place[mid]) * size_[fast] + place[fast];
}

int Cells::cell_of(const double* centre) const {
    return index_of(place_of(centre));
}

int Cells::around(const double* centre, std::array<Seen, 27>& seen) const {
    const std::array<int, 3> home = place_of(centre);
    const auto [slow, mid, fast] = axis_;
    int n = 0;
    for (int code = 0; code < 27; ++code) {
        std::array<int, 3> step{};
        step[static_cast<std::size_t>(slow)] = code / 9 - 1;
        step[static_cast<std::size_t>(mid)] = code / 3 % 3 - 1;
        step[static_cast<std::size_t>(fast)] = code % 3 - 1;
        std::array<int, 3> place{};
        std::array<int, 3> wraps{};
        bool exists = true;
        for (std::size_t k = 0; k < 3; ++k) {
            place[k] = home[k] + step[k];
            if (place[k] >= 0 && place[k] < size_[k])
                continue;
            exists = exists && periodic_[k];
            wraps[k] = place[k] < 0 ? -1 : 1;
            place[k] -= wraps[k] * size_[k];
        }
        if (!exists)
            continue;
        const auto cell = static_cast<std::size_t>(index_of(place));
        const Seen here{begin_[cell], begin_[cell + 1], image_index(wraps[0], wraps[1], wraps[2])};
        if (n > 0 && seen[static_cast<std::size_t>(n - 1)].end == here.begin &&
            seen[static_cast<std::size_t>(n - 1)].image == here.image)
            seen[static_cast<std::size_t>(n - 1)].end = here.end;
        else
            seen[static_cast<std::size_t>(n++)] = here;
    }
    return n;
}

} // namespace tumble::sim3d
