#pragma once

#include "scene/scene.h"

#include <cmath>

namespace tumble::scene {

/// How many box lengths a point stands past the box along a periodic axis, `x` its coordinate in m; 0 along others.
inline double periods_past(const Domain& domain, Eigen::Index axis, double x) {
    if (!domain.periodic[static_cast<std::size_t>(axis)])
        return 0;
    return std::floor((x - domain.box.lo[axis]) / (domain.box.hi[axis] - domain.box.lo[axis]));
}

/// Whether the box reaches through the whole period of an axis, so that it has no sides along it.
inline bool spans_period(const Domain& domain, const Box& box, Eigen::Index axis) {
    return domain.periodic[static_cast<std::size_t>(axis)] && box.lo[axis] <= domain.box.lo[axis] &&
           box.hi[axis] >= domain.box.hi[axis];
}

} // namespace tumble::scene
