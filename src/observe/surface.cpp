#include "observe/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tumble::observe {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double median(std::vector<double> values) {
    const std::size_t half = values.size() / 2;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double bounding_radius(const FrameShape& shape) {
    double radius = 0;
    for (std::size_t i = 0; i < shape.radii.size(); ++i)
        radius = std::max(radius, shape.centres[i].norm() + shape.radii[i]);
    return radius;
}

double strip_width(const Frame& frame) {
    double mass = 0;
    double weighted = 0;
    for (const int shape : frame.shape) {
        const FrameShape& body = frame.layout->shapes[static_cast<std::size_t>(shape)];
        mass += body.mass;
        weighted += body.mass * bounding_radius(body);
    }
    return mass > 0 ? 2 * weighted / mass : 0;
}

/// The axis across: z, and in two dimensions x.
Eigen::Index across(const Frame& frame) {
    return frame.layout->dimension == 2 ? 0 : 2;
}

/// (z, y) of the tops of all spheres, and the lowest point below them.
std::vector<Eigen::Vector2d> sphere_tops(const Frame& frame, double& lowest) {
    std::vector<Eigen::Vector2d> tops;
    lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[i])];
        const Eigen::Matrix3d turn = frame.orientation[i].toRotationMatrix();
        for (std::size_t k = 0; k < shape.radii.size(); ++k) {
            const double y = frame.position[i].y() + turn.row(1).dot(shape.centres[k]);
            const double z = frame.position[i][across(frame)] + turn.row(across(frame)).dot(shape.centres[k]);
            tops.emplace_back(z, y + shape.radii[k]);
            lowest = std::min(lowest, y - shape.radii[k]);
        }
    }
    return tops;
}

double degrees_of(const std::optional<Line>& line) {
    return line ? std::atan(line->slope) * 180 / std::numbers::pi : no_value;
}

std::vector<Eigen::Vector2d> half_of(const Surface& surface, bool left) {
    std::vector<Eigen::Vector2d> half;
    if (surface.points.empty())
        return half;
    const double middle = 0.5 * (surface.points.front().x() + surface.points.back().x());
    for (const Eigen::Vector2d& point : surface.points)
        if (left ? point.x() <= middle : point.x() >= middle)
            half.push_back(point);
    return half;
}

} // namespace

Surface free_surface(const Frame& frame) {
    Surface surface;
    const double width = strip_width(frame);
    if (width <= 0 || frame.layout->periodic[1] || frame.layout->periodic[static_cast<std::size_t>(across(frame))])
        return surface;
    const std::vector<Eigen::Vector2d> tops = sphere_tops(frame, surface.lowest);
    const auto by_z = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() < b.x(); };
    const auto [first, last] = std::minmax_element(tops.begin(), tops.end(), by_z);
    const double start = first->x();
    const double extent = last->x() - start;
    if (!(extent < 1e5 * width)) // also NaN: a state that stopped being sane has no surface
        return surface;
    const auto strips = static_cast<std::size_t>(extent / width) + 1;
    std::vector<const Eigen::Vector2d*> highest(strips, nullptr);
    for (const Eigen::Vector2d& top : tops) {
        const std::size_t strip = std::min(strips - 1, static_cast<std::size_t>((top.x() - start) / width));
        if (!highest[strip] || top.y() > highest[strip]->y())
            highest[strip] = &top;
    }
    for (const Eigen::Vector2d* top : highest)
        if (top)
            surface.points.push_back(*top);
    return surface;
}

std::optional<Line> robust_line(const std::vector<Eigen::Vector2d>& points) {
    if (points.size() < 3)
        return std::nullopt;
    std::vector<double> slopes;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = i + 1; k < points.size(); ++k)
            if (points[k].x() != points[i].x())
                slopes.push_back((points[k].y() - points[i].y()) / (points[k].x() - points[i].x()));
    if (slopes.empty())
        return std::nullopt;
    Line line;
    line.slope = median(std::move(slopes));
    std::vector<double> levels;
    for (const Eigen::Vector2d& point : points)
        levels.push_back(point.y() - line.slope * point.x());
    line.level = median(std::move(levels));
    return line;
}

double surface_slope(const Surface& surface) {
    return degrees_of(robust_line(surface.points));
}
double surface_slope_left(const Surface& surface) {
    return degrees_of(robust_line(half_of(surface, true)));
}
double surface_slope_right(const Surface& surface) {
    return degrees_of(robust_line(half_of(surface, false)));
}

double bulk_height(const Surface& surface) {
    if (surface.points.empty())
        return no_value;
    std::vector<double> heights;
    for (const Eigen::Vector2d& point : surface.points)
        heights.push_back(point.y() - surface.lowest);
    return median(std::move(heights));
}

} // namespace tumble::observe
