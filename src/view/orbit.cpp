#include "view/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::view {

using Eigen::Vector3d;

namespace {

constexpr double radians_per_pixel = std::numbers::pi / 600;
constexpr double steepest = 89.5 * std::numbers::pi / 180;
constexpr double closest = 1e-3; // of the first distance
constexpr double widest = 50;

} // namespace

Orbit::Orbit(const render::Camera& camera, double area_height, double field_of_view_deg, bool flat)
    : flat_(flat), height_(area_height), tangent_(std::tan(field_of_view_deg * std::numbers::pi / 360)),
      target_(camera.target) {
    const Vector3d back = camera.axes.row(2);
    heading_ = std::atan2(back.x(), back.z());
    elevation_ = std::clamp(std::asin(std::clamp(back.y(), -1.0, 1.0)), -steepest, steepest);
    // make_camera: scale = height / 2 / tangent / distance, in pixels a metre at the target.
    distance_ = 0.5 * height_ / (tangent_ * camera.pixels_per_metre(camera.target));
    nearest_ = closest * distance_;
    farthest_ = widest * distance_;
}

Vector3d Orbit::away() const {
    return {std::sin(heading_) * std::cos(elevation_), std::sin(elevation_), std::cos(heading_) * std::cos(elevation_)};
}

Vector3d Orbit::right() const {
    return {std::cos(heading_), 0, -std::sin(heading_)};
}

Vector3d Orbit::up() const {
    return away().cross(right());
}

double Orbit::metres_per_pixel() const {
    return 2 * tangent_ * distance_ / height_;
}

void Orbit::turn(double right, double down) {
    if (flat_)
        return push(right, down);
    heading_ = std::remainder(heading_ - right * radians_per_pixel, 2 * std::numbers::pi);
    elevation_ = std::clamp(elevation_ + down * radians_per_pixel, -steepest, steepest);
}

void Orbit::push(double right_by, double down) {
    target_ += metres_per_pixel() * (up() * down - right() * right_by);
}

void Orbit::zoom(double factor, double right_by, double down) {
    const double before = metres_per_pixel();
    distance_ = std::clamp(distance_ / factor, nearest_, farthest_);
    target_ += (before - metres_per_pixel()) * (right() * right_by - up() * down);
}

void Orbit::write(scene::Render& settings) const {
    settings.camera = "free";
    settings.target = target_;
    settings.eye = target_ + distance_ * away();
}

} // namespace tumble::view
