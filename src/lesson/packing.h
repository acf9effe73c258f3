#pragma once

#include "lesson/walk.h"

#include <optional>

namespace tumble::lesson {

/// Adds to the walk how spheres and cones of the same volume pack, with friction and without; the thesis' figure 5.2.
/// Problems: those of the solver.
std::optional<Problem> add_packing(Walk& walk, double friction);

} // namespace tumble::lesson
