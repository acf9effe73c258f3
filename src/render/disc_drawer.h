#pragma once

#include "render/camera.h"
#include "render/disc_list.h"
#include "render/gl_objects.h"

#include <Eigen/Core>
#include <span>

namespace tumble::render {

/// How bodies of two dimensions look: flat colours, a thin outline around each body, a line that shows how it turns.
struct DiscLook {
    Eigen::Vector3d ink = Eigen::Vector3d::Zero(); // sRGB 0 to 1, of outlines and spokes
    double line = 1;                               // pixels, their thickness
};

/// Draws discs as squares that lie in the plane; samples outside the disc are thrown away, so edges are smoothed as
/// everything else is.
class DiscDrawer {
public:
    static Result<DiscDrawer> open();

    /// Into the bound framebuffer, of that size (pixels): all outlines, then all insides, so that the discs of a clump
    /// make one outline, then the spokes.
    void draw(std::span<const DiscMark> discs, std::span<const SpokeMark> spokes, const Camera& camera, int width,
              int height, const DiscLook& look);

private:
    GlObject disc_program_;
    GlObject spoke_program_;
    GlObject discs_;
    GlObject disc_array_;
    GlObject spokes_;
    GlObject spoke_array_;
};

} // namespace tumble::render
