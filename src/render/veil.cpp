#include "render/veil.h"

#include <algorithm>
#include <array>

namespace tumble::render {

static const char* const whole_picture = R"(#version 400 core
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";

static const char* const lay_over = R"(#version 400 core
uniform sampler2D sum;
uniform sampler2D clearness;
out vec4 shade;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float through = texelFetch(clearness, here, 0).r;
    vec4 all = texelFetch(sum, here, 0);
    if (all.a <= 0.0) discard;
    shade = vec4(all.rgb / all.a, 1.0 - through);
}
)";

constexpr std::array<GLenum, 2> both{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

Result<Veil> Veil::open(const Canvas& canvas) {
    auto program = make_program(whole_picture, lay_over);
    if (!program) {
        return program.problems();
    }
    Veil veil;
    veil.program_ = std::move(*program);
    veil.array_ = make_vertex_array();
    veil.sum_ = make_plain_texture(GL_RGBA16F, canvas.width, canvas.height);
    veil.clear_ = make_plain_texture(GL_R16F, canvas.width, canvas.height);
    veil.target_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, veil.target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, both[0], GL_TEXTURE_2D, veil.sum_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, both[1], GL_TEXTURE_2D, veil.clear_.name(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return Problem{.what = "the OpenGL library cannot draw translucent walls",
                       .fix = "install a current libosmesa6 (Mesa 22 or newer)"};
    }
    return veil;
}

void Veil::begin(const Canvas& canvas) {
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glViewport(0, 0, canvas.width, canvas.height);
    glDrawBuffers(2, both.data());
    constexpr std::array<GLfloat, 4> nothing{0, 0, 0, 0};
    constexpr std::array<GLfloat, 4> all_clear{1, 1, 1, 1};
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_COLOR, 1, all_clear.data());
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
}

void Veil::finish(const Canvas& canvas) {
    // As if at the far end: only where nothing has been drawn the veil is not behind it.
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glEnable(GL_DEPTH_TEST);
    glDepthRange(1, 1);
    glDepthFunc(GL_LEQUAL);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, clear_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, sum_.name());
    glUseProgram(program_.name());
    glUniform1i(glGetUniformLocation(program_.name(), "sum"), 0);
    glUniform1i(glGetUniformLocation(program_.name(), "clearness"), 1);
    glBindVertexArray(array_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
}

} // namespace tumble::render
