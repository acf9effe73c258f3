#pragma once

#include "observe/frame.h"
#include "render/camera.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace tumble::render {

/// One sphere as the graphics library gets it, in view space (right, up, towards the eye; the eye at the origin).
struct SphereMark {
    float x = 0;             // m
    float y = 0;             // m
    float z = 0;             // m
    float radius = 0;        // m
    std::uint32_t color = 0; // bytes red, green, blue, opacity in memory order
};

/// For each shape, the indices of the spheres that show: the others lie wholly inside their neighbours.
/// Decided on 500 points of each sphere, so that a sphere is only left out when no more than a speck of it would show.
std::vector<std::vector<int>> showing_spheres(const observe::FrameLayout& layout);

/// The spheres of a frame in view space. `showing` is showing_spheres(layout), `colors` has one entry a body.
/// Bodies at places that are not finite numbers are left out, as are those with their centres outside the clip (m), or,
/// where it `cuts` bodies, spheres that do not reach into it; and spheres behind the eye of a perspective camera.
std::vector<SphereMark> collect_spheres(const observe::Frame& frame, const std::vector<std::vector<int>>& showing,
                                        const std::vector<std::uint32_t>& colors, const Camera& camera,
                                        const std::optional<Eigen::AlignedBox3d>& clip = {}, bool cuts = false);

} // namespace tumble::render
