#include "render/sphere_drawer.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <new>

namespace tumble::render {

// So many samples travel at once that they stay in a processor's cache on their way.
constexpr std::size_t samples_at_once_travelling = 1U << 20U;

static const char* const run_vertices = R"(#version 400 core
layout(location = 0) in ivec4 run; // left, bottom, right, top
uniform vec2 size;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(vec2(run.xy), vec2(run.zw), corner) / size * 2.0 - 1.0, 0.0, 1.0);
}
)";

static const char* const sample_fragments = R"(#version 400 core
uniform usamplerBuffer seen; // colours, and from `depths` on depths
uniform int depths;
uniform int row_length;
uniform int bottom;
uniform int samples;
out vec4 shade;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int at = (pixel.y - bottom) * row_length + pixel.x * samples + gl_SampleID;
    gl_FragDepth = uintBitsToFloat(texelFetch(seen, at + depths).r);
    shade = unpackUnorm4x8(texelFetch(seen, at).r);
}
)";

/// Where the library takes the canvas' samples.
static Result<Sampling> sampling_of(const Canvas& canvas) {
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    GLint samples = 0;
    glGetIntegerv(GL_SAMPLES, &samples);
    samples = std::max(samples, 1);
    if (samples > samples_at_once || samples_at_once % samples != 0) {
        return Problem{.what = fmt::format("the OpenGL library takes {} samples a pixel", samples),
                       .fix = "install a current libosmesa6 (Mesa 22 or newer)"};
    }
    Sampling sampling;
    sampling.samples = samples;
    for (int lane = 0; lane < samples_at_once; ++lane) {
        std::array<GLfloat, 2> place{0.5F, 0.5F};
        if (samples > 1) {
            glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(lane % samples), place.data());
        }
        sampling.across[lane] = place[0] + static_cast<float>(lane / samples);
        sampling.up[lane] = place[1];
    }
    return sampling;
}

Result<SphereDrawer> SphereDrawer::open(const Canvas& canvas) {
    auto sampling = sampling_of(canvas);
    auto program = make_program(run_vertices, sample_fragments);
    if (!sampling || !program) {
        return sampling ? program.problems() : sampling.problems();
    }
    SphereDrawer drawer;
    drawer.sampling_ = *sampling;
    drawer.program_ = std::move(*program);
    drawer.texels_ = make_buffer();
    drawer.seen_ = make_texture();
    drawer.places_ = make_buffer();
    drawer.array_ = make_vertex_array();
    glBindVertexArray(drawer.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.places_.name());
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 4, GL_INT, sizeof(SphereRaster::Run), nullptr);
    glVertexAttribDivisor(0, 1);
    return drawer;
}

void SphereDrawer::draw(std::span<const SphereMark> marks, const Camera& camera, const Canvas& canvas,
                        const SphereLook& look, SphereRaster& raster, Crew& crew) {
    raster.take(marks, camera, canvas.width, canvas.height, look.window, sampling_, look.skip_hidden, look.cut);
    const std::size_t a_row = raster.row_length() * static_cast<std::size_t>(raster.tile_height());
    const int at_once = std::max(static_cast<int>(samples_at_once_travelling / a_row), 1);
    const std::size_t needed = a_row * static_cast<std::size_t>(std::min(at_once, raster.rows()));
    glBindBuffer(GL_TEXTURE_BUFFER, texels_.name());
    if (room_ < needed) {
        room_ = needed;
        glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(2 * room_ * sizeof(std::uint32_t)), nullptr,
                     GL_STREAM_DRAW);
        glBindTexture(GL_TEXTURE_BUFFER, seen_.name());
        glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, texels_.name());
    }
    for (int row = 0; row < raster.rows(); row += at_once) {
        glBindBuffer(GL_TEXTURE_BUFFER, texels_.name());
        auto* const colors = static_cast<std::uint32_t*>(glMapBuffer(GL_TEXTURE_BUFFER, GL_WRITE_ONLY));
        if (colors == nullptr) {
            throw std::bad_alloc();
        }
        const auto runs =
            raster.draw(row, at_once, {look.lit, look.rim}, colors, reinterpret_cast<float*>(colors + room_), crew);
        glUnmapBuffer(GL_TEXTURE_BUFFER);
        if (!runs.empty()) {
            bring(runs, row * raster.tile_height(), canvas, raster);
        }
    }
}

void SphereDrawer::bring(const std::vector<SphereRaster::Run>& runs, int bottom, const Canvas& canvas,
                         const SphereRaster& raster) {
    const GLuint program = program_.name();
    const auto whole = [&](const char* name, int value) { glUniform1i(glGetUniformLocation(program, name), value); };
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glUseProgram(program);
    glUniform2f(glGetUniformLocation(program, "size"), static_cast<float>(canvas.width),
                static_cast<float>(canvas.height));
    whole("seen", 0);
    whole("depths", static_cast<int>(room_));
    whole("row_length", static_cast<int>(raster.row_length()));
    whole("bottom", bottom);
    whole("samples", sampling_.samples);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_BUFFER, seen_.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glBindVertexArray(array_.name());
    upload(places_, runs.data(), runs.size() * sizeof(SphereRaster::Run));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(runs.size()));
}

} // namespace tumble::render
