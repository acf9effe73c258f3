#pragma once

#include "observe/frame.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace tumble::observe {

/// The free surface seen along x: the highest point of the bulk in each strip of z. In two dimensions x stands for z.
struct Surface {
    std::vector<Eigen::Vector2d> points; // m, (z, y) of the highest point itself, z increasing; empty strips are absent
    double lowest = 0;                   // m, y of the lowest point of any body
};

/// Strips are as wide as twice the mass-weighted mean bounding radius, so that a dense bulk leaves none empty. Highest
/// points are tops of spheres. No points for a frame without bodies, or where y or z is periodic.
Surface free_surface(const Frame& frame);

/// y = level + slope * z.
struct Line {
    double level = 0; // m
    double slope = 0; // -
};

/// Median of the slopes of all pairs of points, then median level (Theil 1950, Sen 1968): up to 29 % of the points may
/// be bodies in flight without pulling the line up. None with fewer than three points or without extent in z.
std::optional<Line> robust_line(const std::vector<Eigen::Vector2d>& points);

/// Angle to the horizontal of the line through the surface, deg, positive where it rises with z; NaN without a line.
double surface_slope(const Surface& surface);
/// The same for the half with z below (left) or above (right) the middle of the surface's extent.
double surface_slope_left(const Surface& surface);
double surface_slope_right(const Surface& surface);

/// Median height of the surface above the lowest point, m; NaN without a surface.
double bulk_height(const Surface& surface);

} // namespace tumble::observe
