#pragma once

#include "observe/frame.h"
#include "render/painter.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace tumble::render::testing {

using Eigen::Vector3d;

/// A folder that goes away with the test.
struct Folder {
    std::filesystem::path path;
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "tumble_render_XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::size_t files() const {
        const std::filesystem::directory_iterator all(path);
        return static_cast<std::size_t>(std::distance(begin(all), end(all)));
    }
};

/// Single spheres of given radii as shapes 0, 1, ...
inline std::shared_ptr<observe::FrameLayout> spheres(const std::vector<double>& radii) {
    auto layout = std::make_shared<observe::FrameLayout>();
    for (const double radius : radii) {
        observe::FrameShape shape;
        shape.centres = {Vector3d::Zero()};
        shape.radii = {radius};
        layout->shapes.push_back(shape);
    }
    return layout;
}

inline observe::Frame empty_frame(std::shared_ptr<const observe::FrameLayout> layout) {
    observe::Frame frame;
    frame.walls.resize(layout->walls.size());
    frame.layout = std::move(layout);
    return frame;
}

inline void add_body(observe::Frame& frame, int shape, const Vector3d& position,
                     const Vector3d& velocity = Vector3d::Zero()) {
    frame.id.push_back(static_cast<std::int64_t>(frame.id.size()));
    frame.shape.push_back(shape);
    frame.position.push_back(position);
    frame.orientation.push_back(Eigen::Quaterniond::Identity());
    frame.velocity.push_back(velocity);
    frame.angular_velocity.push_back(Vector3d::Zero());
}

/// A rectangle across x at x = 0: |y| <= half_y, |z| <= half_z.
inline observe::FrameWall pane(double half_y, double half_z, double opacity) {
    observe::FrameWall wall;
    wall.opacity = opacity;
    wall.vertices = {{0, -half_y, -half_z}, {0, half_y, -half_z}, {0, half_y, half_z}, {0, -half_y, half_z}};
    wall.triangles = {{0, 1, 2}, {0, 2, 3}};
    return wall;
}

/// Front view of the box |x|, |y|, |z| <= half (m), 400 x 400 pixels; speeds 0 to 1 m/s in viridis.
inline scene::Render square_view(double half) {
    scene::Render settings;
    settings.width = 400;
    settings.height = 400;
    settings.range = {0.0, 1.0};
    settings.view = scene::Box{Vector3d::Constant(-half), Vector3d::Constant(half)};
    return settings;
}

inline Painter painter_for(const scene::Render& settings, std::shared_ptr<const observe::FrameLayout> layout,
                           const PainterOptions& options) {
    auto painter = Painter::open(settings, std::move(layout), options);
    REQUIRE_MESSAGE(painter.ok(), to_string(painter.problems()));
    return std::move(*painter);
}

constexpr PainterOptions bare{.lettering = false, .lighting = false};

/// Red, green, blue of a pixel, 0 to 255; x from the left, y from the top.
inline Vector3d pixel(const Picture& picture, int x, int y) {
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return {static_cast<double>(picture.rgba[i]), static_cast<double>(picture.rgba[i + 1]),
            static_cast<double>(picture.rgba[i + 2])};
}

/// How many pixels' worth of `inside` lie over `outside` (two colours, 0 to 255); edge pixels count by their share.
inline double covered_pixels(const Picture& picture, const Vector3d& inside, const Vector3d& outside) {
    const Vector3d way = inside - outside;
    double sum = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            sum += std::clamp((pixel(picture, x, y) - outside).dot(way) / way.squaredNorm(), 0.0, 1.0);
        }
    }
    return sum;
}

} // namespace tumble::render::testing
