#pragma once

#include "observe/frame.h"
#include "render/camera.h"

#include <cstdint>
#include <vector>

namespace tumble::render {

/// One flat disc as the graphics library gets it, in view space (right, up, towards the eye).
struct DiscMark {
    float x = 0;             // m
    float y = 0;             // m
    float z = 0;             // m
    float radius = 0;        // m
    std::uint32_t color = 0; // bytes red, green, blue, opacity in memory order
};

/// The line on a body that shows how it turns, from its centre of mass outwards.
struct SpokeMark {
    float from[3]; // m
    float to[3];   // m
};

/// How far the union of a shape's discs reaches from its centre of mass along its x axis, m.
double spoke_length(const observe::FrameShape& shape);

/// `colors` has one entry a body. Bodies at places that are not finite numbers are left out.
std::vector<DiscMark> collect_discs(const observe::Frame& frame, const std::vector<std::uint32_t>& colors,
                                    const Camera& camera);
/// `lengths` is spoke_length of every shape.
std::vector<SpokeMark> collect_spokes(const observe::Frame& frame, const std::vector<double>& lengths,
                                      const Camera& camera);

} // namespace tumble::render
