#pragma once

#include "render/camera.h"
#include "render/gl_objects.h"

namespace tumble::render {

/// Darkens what lies in crevices: around each pixel's point, the share of a ball of `radius` that is in front of the
/// seen surface says how much light of the sky comes in (volumetric obscurance, B. Loos and P.-P. Sloan 2010).
class CreviceShade {
public:
    static Result<CreviceShade> open(const Canvas& canvas);

    /// Reads the canvas' depth (resolved), multiplies the colour of its samples. radius in m, strength 0 to 1.
    void draw(const Canvas& canvas, const Camera& camera, double radius, double strength);

private:
    GlObject gather_program_;
    GlObject blur_program_;
    GlObject open_sky_;
    GlObject target_;
    GlObject array_;
};

} // namespace tumble::render
