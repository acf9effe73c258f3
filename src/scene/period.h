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

} // namespace tumble::scene
