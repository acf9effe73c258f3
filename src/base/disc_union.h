#pragma once

#include "base/angle_cover.h"

#include <array>

namespace tumble {

/// A disc of a union; of equal ones the lower number counts.
struct UnionDisc {
    double x = 0;      // m
    double y = 0;      // m
    double radius = 0; // m
    int number = 0;
};

/// Integrals of 1, x, y, xx, yy, xy over an area, m2 to m4.
using AreaMoments = std::array<double, 6>;

/// Adds what one arc of a disc's outline (rad, counter-clockwise from x) contributes to the area that it bounds. Green:
/// area = 1/2 of x dy - y dx; x = 1/2 of x^2 dy; y = -1/2 of y^2 dx; xx = 1/3 of x^3 dy; yy = -1/3 of y^3 dx; xy = 1/2
/// of x^2 y dy, each along the whole outline.
void add_arc(const UnionDisc& disc, double from, double to, AreaMoments& sums);

/// Hides on `disc` what lies inside `other`; false when nothing of it is left.
bool hide_inside(const UnionDisc& disc, const UnionDisc& other, AngleCover& cover);

} // namespace tumble
