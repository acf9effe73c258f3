#pragma once

#include "render/gl_objects.h"

namespace tumble::render {

/// Gathers translucent surfaces in any order and lays them over a canvas as one: sorting triangles fails where long
/// ones lie behind each other (weighted blending after M. McGuire and L. Bavoil 2013, JCGT 2(2)). A single surface
/// blends exactly as its opacity says; of several the nearer ones count more. What has been drawn before keeps its
/// colours, sample by sample: a veil over bodies would make them paler than their colours in the legend. The veil
/// itself has one sample a pixel, since lines are drawn along its ends.
class Veil {
public:
    static Result<Veil> open(const Canvas& canvas);

    /// What the fragment shaders of surfaces write: output 0 is vec4(color * cover, cover) * weight, output 1 is cover.
    /// There is no depth: all surfaces count, whatever has been drawn.
    void begin(const Canvas& canvas);
    /// Covers those samples of the canvas at which nothing has been drawn.
    void finish(const Canvas& canvas);

private:
    GlObject program_;
    GlObject array_;
    GlObject sum_;
    GlObject clear_;
    GlObject target_; // framebuffer of the two above
};

} // namespace tumble::render
