#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <limits>
#include <numbers>
#include <utility>

namespace tumble::render {

// Width over height of the narrowest area that eyes are chosen for: what the scene has of a window of 1280 x 720 beside
// the view's panel.
constexpr double usual_shape = 1.2;

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d Camera::to_picture(const Vector3d& world) const {
    const Vector3d v = to_view(world);
    const double zoom = perspective ? scale / -v.z() : scale;
    return {centre.x() + zoom * v.x(), centre.y() - zoom * v.y()};
}

double Camera::pixels_per_metre(const Vector3d& world) const {
    return perspective ? scale / -to_view(world).z() : scale;
}

Eigen::Matrix4f Camera::clip_matrix(int width, int height) const {
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
    const double shift_x = 2 * centre.x() / width - 1;
    const double shift_y = 1 - 2 * centre.y() / height;
    clip(0, 0) = 2 * scale / width;
    clip(1, 1) = 2 * scale / height;
    if (perspective) {
        clip(0, 2) = -shift_x;
        clip(1, 2) = -shift_y;
        clip(2, 2) = (farthest + nearest) / (nearest - farthest);
        clip(2, 3) = 2 * farthest * nearest / (nearest - farthest);
        clip(3, 2) = -1;
    } else {
        clip(0, 3) = shift_x;
        clip(1, 3) = shift_y;
        clip(2, 2) = 2 / (nearest - farthest);
        clip(2, 3) = (farthest + nearest) / (nearest - farthest);
        clip(3, 3) = 1;
    }
    return clip.cast<float>();
}

static std::array<Vector3d, 8> corners_of(const Eigen::AlignedBox3d& box) {
    std::array<Vector3d, 8> corners;
    for (int i = 0; i < 8; ++i) {
        corners[static_cast<std::size_t>(i)] = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    }
    return corners;
}

void Camera::enclose(const Eigen::AlignedBox3d& everything) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vector3d& corner : corners_of(everything)) {
        const double distance = -to_view(corner).z();
        low = std::min(low, distance);
        high = std::max(high, distance);
    }
    // Flat scenes need some depth too, or single precision runs out of digits.
    const double slack = std::max(1e-3 * (high - low), 1e-4 * std::abs(high)) + 1e-9;
    nearest = low - slack;
    farthest = high + slack;
    if (perspective) {
        // A ratio beyond 1e4 would leave too few steps of depth at the far end.
        farthest = std::max(farthest, 1e-6);
        nearest = std::max(nearest, 1e-4 * farthest);
    }
}

static Matrix3d looking(const Vector3d& direction, const Vector3d& up) {
    const Vector3d back = -direction.normalized();
    const Vector3d hint = back.cross(up).norm() > 1e-6 ? up : Vector3d(-Vector3d::UnitZ());
    const Vector3d right = hint.cross(back).normalized();
    Matrix3d axes;
    axes.row(0) = right;
    axes.row(1) = back.cross(right);
    axes.row(2) = back;
    return axes;
}

/// From the middle of a box to what must be in the picture (m): its corners, or the rings they run along as seen from a
/// camera that goes around it.
static std::vector<Vector3d> arms_of(const Eigen::AlignedBox3d& box, const Matrix3d& axes, bool turning) {
    std::vector<Vector3d> arms;
    if (!turning) {
        for (const Vector3d& corner : corners_of(box)) {
            arms.emplace_back(corner - box.center());
        }
        return arms;
    }
    constexpr int around = 72; // one at each 5 degrees: what lies between reaches 0.1 % further, well within the margin
    const Vector3d half = 0.5 * box.sizes(), right = axes.row(0).transpose(), away = right.cross(Vector3d::UnitY());
    const double radius = std::hypot(half.x(), half.z());
    for (int k = 0; k < around; ++k) {
        const double angle = 2 * std::numbers::pi * k / around;
        const Vector3d flat = radius * (std::cos(angle) * right + std::sin(angle) * away);
        arms.emplace_back(flat + half.y() * Vector3d::UnitY());
        arms.emplace_back(flat - half.y() * Vector3d::UnitY());
    }
    return arms;
}

/// Places the eye or the scale so that the box just fits.
static void fit(Camera& camera, const Eigen::AlignedBox3d& box, const Area& area, double field_of_view, bool turning) {
    const double half_width = 0.5 * area.width() * (1 - 2 * camera_margin);
    const double half_height = 0.5 * area.height() * (1 - 2 * camera_margin);
    camera.target = box.center();
    double across = 1e-9;
    double along = 1e-9;
    const std::vector<Vector3d> arms = arms_of(box, camera.axes, turning);
    for (const Vector3d& arm : arms) {
        const Vector3d v = camera.axes * arm;
        across = std::max(across, std::abs(v.x()));
        along = std::max(along, std::abs(v.y()));
    }
    if (!camera.perspective) {
        camera.scale = std::min(half_width / across, half_height / along);
        camera.eye = camera.target + camera.axes.row(2).transpose() * box.diagonal().norm();
        return;
    }
    camera.scale = 0.5 * area.height() / std::tan(0.5 * field_of_view);
    double distance = 1e-6;
    for (const Vector3d& arm : arms) {
        const Vector3d v = camera.axes * arm;
        distance = std::max(distance, v.z() + std::abs(v.x()) * camera.scale / half_width);
        distance = std::max(distance, v.z() + std::abs(v.y()) * camera.scale / half_height);
    }
    camera.eye = camera.target + camera.axes.row(2).transpose() * distance;
}

/// The largest scale at which no corner of the box lies beyond the left or right margin; 0 where one does not lie
/// before the eye.
static double scale_across(const Camera& camera, const Eigen::AlignedBox3d& box, const Area& area) {
    const double half_width = 0.5 * area.width() * (1 - 2 * camera_margin);
    double scale = std::numeric_limits<double>::infinity();
    for (const Vector3d& corner : corners_of(box)) {
        const Vector3d v = camera.to_view(corner);
        const double depth = camera.perspective ? std::max(-v.z(), 0.0) : 1;
        scale = std::min(scale, half_width * depth / std::max(std::abs(v.x()), 1e-12));
    }
    return scale;
}

/// A camera that goes around must not breathe: it has one scale, whatever the box needs from where it is.
static void open_wider(Camera& camera, const Eigen::AlignedBox3d& box, const Area& area, bool turning) {
    const double least = camera.scale * area.width() / (usual_shape * area.height());
    const double wanted = turning ? least : std::max(least, scale_across(camera, box, area));
    camera.scale = std::min(camera.scale, wanted);
}

static Result<Vector3d> direction_of(const scene::Render& settings) {
    if (settings.camera == "front") {
        return Vector3d(Vector3d::UnitX());
    }
    if (settings.camera == "side") {
        return Vector3d(-Vector3d::UnitZ());
    }
    if (settings.camera == "top") {
        return Vector3d(-Vector3d::UnitY());
    }
    if (settings.camera != "free") {
        return Problem{.key = "render.camera",
                       .what = fmt::format("there is no camera '{}'", settings.camera),
                       .fix = "take front, side, top or free"};
    }
    const Vector3d direction = settings.target - settings.eye;
    if (direction.norm() > 0) {
        return direction;
    }
    if (settings.eye.norm() > 0) {
        return Problem{.key = "render.eye",
                       .what = "the free camera's eye and target are the same point",
                       .fix = "move one of them, or leave both out to look from the front, right and above"};
    }
    return Vector3d(1.0, -0.55, -0.75);
}

double view_height(const Area& area, const std::optional<Held>& held) {
    return held && held->shape > 0 ? std::min(area.height(), area.width() / held->shape) : area.height();
}

Result<Camera> make_camera(const scene::Render& settings, const Eigen::AlignedBox3d& box, const Area& area, double time,
                           const std::optional<Held>& held) {
    const auto direction = direction_of(settings);
    if (!direction) {
        return direction.problems();
    }
    if (settings.projection != "orthographic" && settings.projection != "perspective") {
        return Problem{.key = "render.projection",
                       .what = fmt::format("there is no projection '{}'", settings.projection),
                       .fix = "take orthographic or perspective"};
    }
    if (!(settings.field_of_view_deg > 0 && settings.field_of_view_deg < 170)) {
        return Problem{.key = "render.field_of_view_deg",
                       .what = fmt::format("a field of view of {} degrees cannot be drawn", settings.field_of_view_deg),
                       .fix = "take more than 0 and less than 170, usually 20 to 60"};
    }
    const double field_of_view = settings.field_of_view_deg * std::numbers::pi / 180;
    Camera camera;
    camera.perspective = settings.projection == "perspective";
    const bool turns = settings.turn_deg_s != 0 && settings.camera == "free";
    const double angle = turns ? settings.turn_deg_s * time * std::numbers::pi / 180 : 0;
    const Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
    camera.axes = looking(turns ? Vector3d(turn * *direction) : *direction, Vector3d::UnitY());
    camera.centre = {0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom)};
    if (settings.camera == "free" && settings.eye != settings.target) {
        camera.eye = turns ? Vector3d(settings.target + turn * (settings.eye - settings.target)) : settings.eye;
        camera.target = settings.target;
        camera.scale = 0.5 * view_height(area, held) / std::tan(0.5 * field_of_view);
        if (!camera.perspective) {
            camera.scale /= (settings.target - settings.eye).norm();
        }
        if (!held) {
            open_wider(camera, box, area, turns);
        }
    } else {
        fit(camera, box, area, field_of_view, turns);
    }
    camera.enclose(box);
    return camera;
}

BoundsOver::BoundsOver(std::shared_ptr<const observe::FrameLayout> layout) : layout_(std::move(layout)) {
    // Roundings at its rim must not make the reach too short to pass a body over.
    constexpr double ample = 1 + 1e-9;
    for (const observe::FrameShape& shape : layout_->shapes) {
        double& reach = reach_.emplace_back(0);
        for (std::size_t s = 0; s < shape.centres.size(); ++s) {
            reach = std::max(reach, ample * (shape.centres[s].norm() + shape.radii[s]));
        }
    }
}

void BoundsOver::take_in_body(const observe::Frame& frame, std::size_t body) {
    const auto shape = static_cast<std::size_t>(frame.shape[body]);
    const Vector3d& place = frame.position[body];
    if (box_.contains(Eigen::AlignedBox3d(place.array() - reach_[shape], place.array() + reach_[shape]))) {
        return;
    }
    const observe::FrameShape& spheres = layout_->shapes[shape];
    for (std::size_t s = 0; s < spheres.centres.size(); ++s) {
        const Vector3d centre = place + frame.orientation[body] * spheres.centres[s];
        box_.extend(Eigen::AlignedBox3d(centre.array() - spheres.radii[s], centre.array() + spheres.radii[s]));
    }
}

void BoundsOver::take_in_wall(const observe::Frame& frame, std::size_t wall) {
    const observe::WallPlace& place = frame.walls[wall];
    if (wall < walls_.size() && walls_[wall].rotation == place.rotation &&
        walls_[wall].translation == place.translation) {
        return;
    }
    for (const Vector3d& vertex : layout_->walls[wall].vertices) {
        box_.extend(place.rotation * vertex + place.translation);
    }
}

void BoundsOver::take_in(const observe::Frame& frame) {
    const std::size_t walls = std::min(layout_->walls.size(), frame.walls.size());
    const auto has_spheres = [&](int shape) { return reach_[static_cast<std::size_t>(shape)] > 0; };
    bool any = std::any_of(frame.shape.begin(), frame.shape.end(), has_spheres);
    for (std::size_t w = 0; w < walls; ++w) {
        any = any || !layout_->walls[w].vertices.empty();
        take_in_wall(frame, w);
    }
    walls_ = frame.walls;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        take_in_body(frame, b);
    }
    if (!any) {
        box_.extend(Eigen::AlignedBox3d(layout_->domain_lo, layout_->domain_hi));
    }
}

Eigen::AlignedBox3d bounds_of(const observe::Frame& frame) {
    BoundsOver over(frame.layout);
    over.take_in(frame);
    return over.box();
}

} // namespace tumble::render
