#include "render/sphere_list.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace tumble::render {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Points that lie evenly on the unit sphere (golden-angle spiral).
static std::vector<Vector3d> even_directions(int count) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count;
        const double r = std::sqrt(1 - z * z);
        points.emplace_back(r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z);
    }
    return points;
}

static bool inside_another(const observe::FrameShape& shape, std::size_t own, const Vector3d& point) {
    for (std::size_t other = 0; other < shape.centres.size(); ++other) {
        if (other != own && (point - shape.centres[other]).norm() < shape.radii[other]) {
            return true;
        }
    }
    return false;
}

static bool shows(const observe::FrameShape& shape, std::size_t sphere, const std::vector<Vector3d>& directions) {
    for (const Vector3d& direction : directions) {
        if (!inside_another(shape, sphere, shape.centres[sphere] + shape.radii[sphere] * direction)) {
            return true;
        }
    }
    return false;
}

std::vector<std::vector<int>> showing_spheres(const observe::FrameLayout& layout) {
    const std::vector<Vector3d> directions = even_directions(500);
    std::vector<std::vector<int>> showing;
    for (const observe::FrameShape& shape : layout.shapes) {
        std::vector<int>& list = showing.emplace_back();
        for (std::size_t s = 0; s < shape.centres.size(); ++s) {
            if (shows(shape, s, directions)) {
                list.push_back(static_cast<int>(s));
            }
        }
    }
    return showing;
}

std::vector<SphereMark> collect_spheres(const observe::Frame& frame, const std::vector<std::vector<int>>& showing,
                                        const std::vector<std::uint32_t>& colors, const Camera& camera,
                                        const std::optional<Eigen::AlignedBox3d>& clip, bool cuts) {
    std::vector<SphereMark> marks;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const auto kind = static_cast<std::size_t>(frame.shape[b]);
        const observe::FrameShape& shape = frame.layout->shapes[kind];
        const Vector3d place = camera.to_view(frame.position[b]);
        const Matrix3d turn = camera.axes * frame.orientation[b].toRotationMatrix();
        if (!place.allFinite() || !turn.allFinite() || (clip && !cuts && !clip->contains(frame.position[b]))) {
            continue;
        }
        for (const int s : showing[kind]) {
            const auto i = static_cast<std::size_t>(s);
            const Vector3d centre = place + turn * shape.centres[i];
            if (camera.perspective && -centre.z() <= shape.radii[i]) {
                continue;
            }
            if (clip && cuts) {
                const Vector3d world = frame.position[b] + frame.orientation[b] * shape.centres[i];
                if (clip->squaredExteriorDistance(world) >= shape.radii[i] * shape.radii[i]) {
                    continue;
                }
            }
            const Eigen::Vector3f at = centre.cast<float>();
            marks.push_back({at.x(), at.y(), at.z(), static_cast<float>(shape.radii[i]), colors[b]});
        }
    }
    return marks;
}

} // namespace tumble::render
