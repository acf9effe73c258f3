#include "render/disc_drawer.h"

#include <algorithm>
#include <cstddef>

namespace tumble::render {

static const char* const disc_vertex = R"(#version 400 core
layout(location = 0) in vec4 disc;
layout(location = 1) in vec4 color;
uniform mat4 clip;
uniform float less; // m, taken off the radius
uniform vec4 ink;   // opacity 0: the disc's own colour
sample out vec2 offset;
flat out float reach;
flat out vec4 paint;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    reach = max(disc.w - less, 0.0);
    offset = reach * corner;
    paint = ink.a > 0.0 ? ink : vec4(color.rgb, 1.0);
    gl_Position = clip * vec4(disc.xy + offset, disc.z, 1.0);
}
)";

static const char* const disc_fragment = R"(#version 400 core
sample in vec2 offset;
flat in float reach;
flat in vec4 paint;
out vec4 shade;
void main() {
    if (dot(offset, offset) > reach * reach) discard;
    shade = paint;
}
)";

static const char* const spoke_vertex = R"(#version 400 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
uniform mat4 clip;
uniform float half_line; // m
void main() {
    vec2 along = to.xy - from.xy;
    float reach = length(along);
    along = reach > 0.0 ? along / reach : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 1) * 2.0 - 1.0) * half_line;
    vec3 place = (gl_VertexID >> 1) == 0 ? from : to;
    gl_Position = clip * vec4(place.xy + across, place.z, 1.0);
}
)";

static const char* const spoke_fragment = R"(#version 400 core
uniform vec4 ink;
out vec4 shade;
void main() { shade = ink; }
)";

Result<DiscDrawer> DiscDrawer::open() {
    auto disc = make_program(disc_vertex, disc_fragment);
    auto spoke = make_program(spoke_vertex, spoke_fragment);
    if (!disc || !spoke) {
        return disc ? spoke.problems() : disc.problems();
    }
    const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    DiscDrawer drawer;
    drawer.disc_program_ = std::move(*disc);
    drawer.spoke_program_ = std::move(*spoke);
    drawer.discs_ = make_buffer();
    drawer.disc_array_ = make_vertex_array();
    glBindVertexArray(drawer.disc_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.discs_.name());
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(DiscMark), nullptr);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(DiscMark), at(offsetof(DiscMark, color)));
    drawer.spokes_ = make_buffer();
    drawer.spoke_array_ = make_vertex_array();
    glBindVertexArray(drawer.spoke_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.spokes_.name());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(SpokeMark), at(offsetof(SpokeMark, from)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(SpokeMark), at(offsetof(SpokeMark, to)));
    for (const GlObject* array : {&drawer.disc_array_, &drawer.spoke_array_}) {
        glBindVertexArray(array->name());
        for (GLuint i = 0; i < 2; ++i) {
            glEnableVertexAttribArray(i);
            glVertexAttribDivisor(i, 1);
        }
    }
    return drawer;
}

void DiscDrawer::draw(std::span<const DiscMark> discs, std::span<const SpokeMark> spokes, const Camera& camera,
                      int width, int height, const DiscLook& look) {
    const Eigen::Matrix4f clip = camera.clip_matrix(width, height);
    const double line = look.line / camera.pixels_per_metre(camera.target); // m
    const Eigen::Vector3f ink = look.ink.cast<float>();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glUseProgram(disc_program_.name());
    const auto place = [](GLuint program, const char* name) { return glGetUniformLocation(program, name); };
    glUniformMatrix4fv(place(disc_program_.name(), "clip"), 1, GL_FALSE, clip.data());
    glBindVertexArray(disc_array_.name());
    upload(discs_, discs.data(), discs.size_bytes());
    for (const bool outline : {true, false}) {
        glUniform1f(place(disc_program_.name(), "less"), outline ? 0.0F : static_cast<float>(line));
        glUniform4f(place(disc_program_.name(), "ink"), ink.x(), ink.y(), ink.z(), outline ? 1.0F : 0.0F);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(discs.size()));
    }
    glUseProgram(spoke_program_.name());
    glUniformMatrix4fv(place(spoke_program_.name(), "clip"), 1, GL_FALSE, clip.data());
    glUniform1f(place(spoke_program_.name(), "half_line"), static_cast<float>(0.5 * line));
    glUniform4f(place(spoke_program_.name(), "ink"), ink.x(), ink.y(), ink.z(), 1.0F);
    glBindVertexArray(spoke_array_.name());
    upload(spokes_, spokes.data(), spokes.size_bytes());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(spokes.size()));
    glEnable(GL_DEPTH_TEST);
}

} // namespace tumble::render
