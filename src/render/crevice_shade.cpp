#include "render/crevice_shade.h"

#include <algorithm>

namespace tumble::render {

constexpr int rows_at_once = 16; // that one thread works on

static const char* const whole_picture = R"(#version 400 core
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";

static const char* const darken = R"(#version 400 core
uniform sampler2D light;
out vec4 shade;
void main() { shade = vec4(vec3(texelFetch(light, ivec2(gl_FragCoord.xy), 0).r), 1.0); }
)";

Result<CreviceShade> CreviceShade::open(const Canvas& canvas) {
    auto program = make_program(whole_picture, darken);
    if (!program) {
        return program.problems();
    }
    CreviceShade shade;
    shade.program_ = std::move(*program);
    shade.array_ = make_vertex_array();
    shade.light_ = make_plain_texture(GL_R8, canvas.width, canvas.height);
    return shade;
}

CreviceJob CreviceShade::job_for(const Canvas& canvas, const Camera& camera, double radius, double strength) {
    CreviceJob job;
    job.width = canvas.width;
    job.height = canvas.height;
    constexpr int before = 8, behind = 16; // entries; render/kernels.h
    job.row = before + (canvas.width + 7) / 8 * 8 + behind;
    const auto all = static_cast<std::size_t>(job.row) * static_cast<std::size_t>(canvas.height);
    depth_.resize(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height));
    distance_.resize(all);
    sky_.resize(all);
    shade_.resize(all);
    job.depth = depth_.data();
    job.perspective = camera.perspective;
    job.nearest = static_cast<float>(camera.nearest);
    job.farthest = static_cast<float>(camera.farthest);
    job.radius = static_cast<float>(radius);
    job.scale = static_cast<float>(camera.scale);
    job.strength = static_cast<float>(strength);
    job.distance = distance_.data() + before;
    job.sky = sky_.data() + before;
    job.shade = shade_.data() + before;
    return job;
}

void CreviceShade::draw(const Canvas& canvas, const Camera& camera, double radius, double strength, Crew& crew) {
    const CreviceJob job = job_for(canvas, camera, radius, strength);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.resolved.name());
    glReadPixels(0, 0, canvas.width, canvas.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth_.data());
    const int parts = (canvas.height + rows_at_once - 1) / rows_at_once;
    const auto share = [&](const auto& work) {
        crew.share(parts, [&](int part) {
            CreviceJob mine = job;
            mine.first = part * rows_at_once;
            mine.last = std::min(mine.first + rows_at_once, job.height);
            work(mine, part);
        });
    };
    share([&](const CreviceJob& mine, int) { kernels_->measure_distances(mine); });
    share([&](const CreviceJob& mine, int) { kernels_->gather_sky(mine); });
    std::vector<char> darker(static_cast<std::size_t>(parts)); // a thread each: no bits side by side
    share([&](const CreviceJob& mine, int part) {
        kernels_->blur_sky(mine);
        for (int y = mine.first; y < mine.last && darker[static_cast<std::size_t>(part)] == 0; ++y) {
            const std::uint8_t* begin = mine.shade + y * mine.row;
            darker[static_cast<std::size_t>(part)] =
                std::any_of(begin, begin + mine.width, [](std::uint8_t v) { return v != 255; }) ? 1 : 0;
        }
    });
    const auto first = std::find(darker.begin(), darker.end(), 1);
    const auto last = std::find(darker.rbegin(), darker.rend(), 1).base();
    if (first < last) {
        // A row more on either side: of a pixel's samples Mesa's scissor lets some of the neighbour's through.
        multiply(canvas, job, std::max(rows_at_once * static_cast<int>(first - darker.begin()) - 1, 0),
                 std::min(rows_at_once * static_cast<int>(last - darker.begin()) + 1, canvas.height));
    }
}

/// Rows low to high of the canvas, the last not included.
void CreviceShade::multiply(const Canvas& canvas, const CreviceJob& job, int low, int high) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, light_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(job.row));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, low, canvas.width, high - low, GL_RED, GL_UNSIGNED_BYTE,
                    job.shade + low * job.row);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glUseProgram(program_.name());
    glUniform1i(glGetUniformLocation(program_.name(), "light"), 0);
    glBindVertexArray(array_.name());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    const int above = low == 0 ? 0 : low + 1, below = high == canvas.height ? high : high - 1;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, above, canvas.width, below - above);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

} // namespace tumble::render
