#pragma once

#include "base/problem.h"
#include "base/stop.h"
#include "base/tally.h"
#include "fit/shapes.h"
#include "fit/solid.h"

#include <vector>

/// A given number of spheres inside a solid, so that they fill it; no chance enters, the same input gives the same
/// spheres. docs/bodies.md.
namespace tumble::fit {

struct Wanted {
    int spheres = 0;
    double smallest = 0; // m, the least radius
};

/// An axis and a ring.
constexpr int fewest_in_a_cone = 8;

/// Spheres on the cone's medial axis, where the largest that fit inside touch base and mantle at once: some on the axis
/// from the inscribed sphere to the tip, the others in rings towards the rim of the base. Radii fall off
/// geometrically; rings hold spheres in proportion to their length over their radius. How many stand on the axis and
/// in how many rings is tried out, and the fullest kept; `tally` hears of each try. Problems: too few spheres, a
/// smallest radius that is not below that of the inscribed sphere.
Result<std::vector<Sphere>> spheres_in(const Cone& cone, const Wanted& wanted, const Tally& tally = {});

/// Largest-gain choice among the spheres that touch the surface from inside about the points of a grid (40 along the
/// longest side): each time the one that holds most of the grid's points that no sphere holds yet. Problems: no point
/// is as deep as the smallest radius, more spheres wanted than there are such points, stopped. The number of threads
/// changes the time taken only; `tally` hears of layers of the grid, of its points and of spheres.
Result<std::vector<Sphere>> spheres_in(const Solid& solid, const Wanted& wanted, int threads = 1,
                                       StopFlag stop = nullptr, const Tally& tally = {});

} // namespace tumble::fit
