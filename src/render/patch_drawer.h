#pragma once

#include "render/gl_objects.h"
#include "render/patch.h"

#include <span>

namespace tumble::render {

/// Draws patches over what is there, in their order.
class PatchDrawer {
public:
    static Result<PatchDrawer> open();

    /// Into the bound framebuffer of that size (pixels).
    void draw(std::span<const Patch> patches, int width, int height);

private:
    GlObject program_;
    GlObject corners_;
    GlObject array_;
};

} // namespace tumble::render
