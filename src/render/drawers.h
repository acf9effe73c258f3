#pragma once

#include "observe/frame.h"
#include "render/crevice_shade.h"
#include "render/disc_drawer.h"
#include "render/gl_objects.h"
#include "render/patch_drawer.h"
#include "render/sphere_drawer.h"
#include "render/theme.h"
#include "render/wall_drawer.h"
#include "scene/scene.h"

namespace tumble::render {

/// Everything that holds a name in the GL context, to be dropped as one while the context is current.
struct Drawers {
    Canvas canvas;
    SphereDrawer spheres;
    DiscDrawer discs;
    WallDrawer walls;
    CreviceShade crevices;
    PatchDrawer patches;

    /// For pictures of the settings' size with so many samples a pixel. Problems: a size that cannot be drawn, a
    /// graphics library that is too old.
    static Result<Drawers> open(const scene::Render& settings, const observe::FrameLayout& layout, const Theme& theme,
                                int samples);
};

} // namespace tumble::render
