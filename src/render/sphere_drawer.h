#pragma once

#include "render/area.h"
#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/sphere_list.h"
#include "render/sphere_raster.h"

#include <optional>
#include <span>

namespace tumble::render {

/// How spheres look.
struct SphereLook {
    Area window;                              // pixels, where they are seen
    float rim = 0;                            // brightens (below 0: darkens) what bends away from the eye
    bool lit = true;                          // false: bare colours
    bool skip_hidden = true;                  // false: draws what lies behind others too, for the same picture
    std::optional<Eigen::AlignedBox3d> cut{}; // m: its faces cut spheres open
};

/// Brings spheres that a raster draws into a canvas: colour and depth of every sample, so that what else is drawn there
/// cuts them where it should.
class SphereDrawer {
public:
    /// Problems: a library that takes a number of samples a pixel that the raster does not know.
    static Result<SphereDrawer> open(const Canvas& canvas);

    /// Into the canvas' samples.
    void draw(std::span<const SphereMark> marks, const Camera& camera, const Canvas& canvas, const SphereLook& look,
              SphereRaster& raster, Crew& crew);

private:
    void bring(const std::vector<SphereRaster::Run>& runs, int bottom, const Canvas& canvas,
               const SphereRaster& raster);

    Sampling sampling_;
    GlObject program_;
    GlObject texels_;
    GlObject seen_;        // the texels as a texture
    std::size_t room_ = 0; // samples that texels_ holds
    GlObject places_;
    GlObject array_;
};

} // namespace tumble::render
