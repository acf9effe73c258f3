#pragma once

#include "base/parallel_for.h"
#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/kernels.h"

#include <cstdint>
#include <vector>

namespace tumble::render {

/// Darkens what lies in crevices: around each pixel's point, the share of a ball of `radius` that is in front of the
/// seen surface says how much light of the sky comes in (volumetric obscurance, B. Loos and P.-P. Sloan 2010).
class CreviceShade {
public:
    static Result<CreviceShade> open(const Canvas& canvas);

    /// Reads the canvas' depth (resolved), multiplies the colour of its samples. radius in m, strength 0 to 1.
    void draw(const Canvas& canvas, const Camera& camera, double radius, double strength, Crew& crew);

private:
    [[nodiscard]] CreviceJob job_for(const Canvas& canvas, const Camera& camera, double radius, double strength);
    void multiply(const Canvas& canvas, const CreviceJob& job, int low, int high);

    const Kernels* kernels_ = &choose_kernels();
    GlObject program_;
    GlObject light_; // the shade as a texture
    GlObject array_;
    std::vector<float> depth_;
    std::vector<float> distance_;
    std::vector<float> sky_;
    std::vector<std::uint8_t> shade_;
};

} // namespace tumble::render
