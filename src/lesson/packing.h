#pragma once

#include "lesson/walk.h"

#include <optional>

namespace tumble::lesson {

/// A bed of spheres, and one of cones.
struct Packing {
    double friction = 0;
    double width = 0; // m
    int bodies = 0;
    int fills = 0; // from as many seeds
};

/// Adds to the walk how spheres and cones of the same volume pack, with friction and without; the thesis' figure 5.2.
/// Problems: those of the solver.
std::optional<Problem> add_packing(Walk& walk, const Packing& packing);

} // namespace tumble::lesson
