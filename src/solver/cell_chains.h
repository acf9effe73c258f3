#pragma once

#include "scene/period.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tumble::solver {

/// Points by the cell of the domain that they stand in, growing as points come in: what a fill asks for room. Between
/// rebuilds of the neighbours' lists a body may stand beyond a periodic side; here all stand in the box.
template <int dimensions> class CellChains {
public:
    using Point = Eigen::Matrix<double, dimensions, 1>;
    using Place = std::array<int, dimensions>;

    /// Cells are about as wide as `width`, m; points nearer than that stand in neighbouring ones.
    CellChains(const scene::Domain& domain, double width) : domain_(domain) {
        std::size_t cells = 1;
        for (std::size_t k = 0; k < dimensions; ++k) {
            size_[k] = std::max(static_cast<int>(length(k) / width), 1);
            cells *= static_cast<std::size_t>(size_[k]);
        }
        first_.assign(cells, -1);
    }

    /// From a point to where it stands in the box along periodic axes, m.
    [[nodiscard]] Point way_into_box(const Point& point) const {
        Point way;
        for (int axis = 0; axis < dimensions; ++axis)
            way[axis] =
                -scene::periods_past(domain_, axis, point[axis]) * (domain_.box.hi[axis] - domain_.box.lo[axis]);
        return way;
    }

    /// A point in the box; the first one's number is 0.
    void add(const Point& point) {
        int& first = first_[index(place(point))];
        next_.push_back(first);
        first = static_cast<int>(next_.size()) - 1;
    }

    /// Whether meets(number, shift) for one of the points in the cells around `point`, its own included; a point is
    /// seen `shift` m away from where it stands.
    template <class Meets> [[nodiscard]] bool any_near(const Point& point, Meets&& meets) const {
        const Place home = place(point);
        Place at{};
        for (int code = 0; code < around; ++code) {
            int digits = code;
            for (std::size_t k = 0; k < dimensions; ++k, digits /= 3)
                at[k] = home[k] + digits % 3 - 1;
            Point shift = Point::Zero();
            if (!wrap(at, shift))
                continue;
            for (int number = first_[index(at)]; number >= 0; number = next_[static_cast<std::size_t>(number)])
                if (meets(static_cast<std::size_t>(number), shift))
                    return true;
        }
        return false;
    }

private:
    static constexpr int around = dimensions == 2 ? 9 : 27;

    [[nodiscard]] double length(std::size_t axis) const {
        const auto k = static_cast<Eigen::Index>(axis);
        return domain_.box.hi[k] - domain_.box.lo[k];
    }

    /// Brings a place past a periodic side back; false past another.
    bool wrap(Place& at, Point& shift) const {
        for (std::size_t k = 0; k < dimensions; ++k) {
            if (at[k] >= 0 && at[k] < size_[k])
                continue;
            if (!domain_.periodic[k])
                return false;
            const int turn = at[k] < 0 ? -1 : 1;
            shift[static_cast<Eigen::Index>(k)] = turn * length(k);
            at[k] -= turn * size_[k];
        }
        return true;
    }

    [[nodiscard]] Place place(const Point& point) const {
        Place at{};
        for (std::size_t k = 0; k < dimensions; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double part = (point[axis] - domain_.box.lo[axis]) / length(k);
            at[k] = std::clamp(static_cast<int>(std::floor(part * size_[k])), 0, size_[k] - 1);
        }
        return at;
    }

    [[nodiscard]] std::size_t index(const Place& at) const {
        std::size_t index = 0;
        for (std::size_t k = 0; k < dimensions; ++k)
            index = index * static_cast<std::size_t>(size_[k]) + static_cast<std::size_t>(at[k]);
        return index;
    }

    const scene::Domain& domain_;
    Place size_{};
    std::vector<int> first_; // per cell, of its points; -1: none
    std::vector<int> next_;  // per point, in its cell
};

} // namespace tumble::solver
