#pragma once

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/sphere_list.h"

#include <span>

namespace tumble::render {

/// Draws spheres as squares that face the eye; each sample meets the true sphere and gets its depth, so that spheres
/// cut each other where they should, and edges and cuts are smoothed alike.
class SphereDrawer {
public:
    static Result<SphereDrawer> open();

    /// Into the bound framebuffer, of that size (pixels). `rim` brightens (below 0: darkens) what bends away from the
    /// eye; `lit` false draws the bare colours.
    void draw(std::span<const SphereMark> marks, const Camera& camera, int width, int height, float rim, bool lit);

private:
    GlObject parallel_;
    GlObject perspective_;
    GlObject marks_;
    GlObject array_;
};

} // namespace tumble::render
