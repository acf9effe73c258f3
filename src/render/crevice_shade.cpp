#include "render/crevice_shade.h"

#include <string>

namespace tumble::render {

static const char* const whole_picture = R"(#version 400 core
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";

// Distances are read from the depth as written by the spheres: linear for a parallel projection, else a + b / distance.
static const char* const with_distances = R"(#version 400 core
uniform sampler2D depth;
uniform bool perspective;
uniform float nearest;
uniform float farthest;
uniform float radius;
float distance_of(float d) {
    return perspective ? nearest * farthest / (farthest - d * (farthest - nearest)) : mix(nearest, farthest, d);
}
)";

static const char* const gather_source = R"(
uniform float scale;
out float sky;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float d = texelFetch(depth, here, 0).r;
    sky = 1.0;
    if (d >= 1.0) return;
    float own = distance_of(d);
    float reach = clamp(radius * (perspective ? scale / own : scale), 3.0, 64.0);
    ivec2 last = textureSize(depth, 0) - 1;
    // 16 points on a spiral, turned from pixel to pixel in a pattern of 4 x 4 that the blur takes out again.
    float turn = float((here.x & 3) * 4 + (here.y & 3)) * 0.3927 * 2.5;
    float free_length = 0.0;
    float whole_length = 0.0;
    for (int i = 0; i < 16; ++i) {
        float r = sqrt((float(i) + 0.5) / 16.0);
        float angle = 2.39996 * float(i) + turn;
        ivec2 there = clamp(here + ivec2(round(reach * r * vec2(cos(angle), sin(angle)))), ivec2(0), last);
        float behind = distance_of(texelFetch(depth, there, 0).r) - own;
        float half_length = radius * sqrt(1.0 - r * r);
        float open_length = clamp(behind + half_length, 0.0, 2.0 * half_length);
        // What lies far in front only shades a little: it is another body, not this crevice's wall.
        float far_front = clamp(-behind / radius - 2.0, 0.0, 3.0) / 3.0;
        free_length += mix(open_length, 0.75 * half_length, far_front);
        whole_length += half_length;
    }
    sky = clamp(free_length / whole_length, 0.0, 1.0);
}
)";

static const char* const blur_source = R"(
uniform sampler2D sky;
uniform float strength;
out vec4 shade;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(sky, 0) - 1;
    float d = texelFetch(depth, here, 0).r;
    if (d >= 1.0) {
        shade = vec4(1.0);
        return;
    }
    float own = distance_of(d);
    float sum = 0.0;
    float count = 0.0;
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) {
            ivec2 there = clamp(here + ivec2(x, y), ivec2(0), last);
            // Another body's shade would shine over the edge between them; a little of it keeps the edge smooth.
            float same = abs(distance_of(texelFetch(depth, there, 0).r) - own) < 0.3 * radius ? 1.0 : 0.2;
            sum += same * texelFetch(sky, there, 0).r;
            count += same;
        }
    }
    float open_sky = sum / max(count, 1.0);
    shade = vec4(vec3(mix(1.0, open_sky, strength)), 1.0);
}
)";

Result<CreviceShade> CreviceShade::open(const Canvas& canvas) {
    auto gather = make_program(whole_picture, with_distances + std::string(gather_source));
    auto blur = make_program(whole_picture, with_distances + std::string(blur_source));
    if (!gather || !blur) {
        return gather ? blur.problems() : gather.problems();
    }
    CreviceShade shade;
    shade.gather_program_ = std::move(*gather);
    shade.blur_program_ = std::move(*blur);
    shade.array_ = make_vertex_array();
    shade.open_sky_ = make_plain_texture(GL_R8, canvas.width, canvas.height);
    shade.target_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, shade.target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shade.open_sky_.name(), 0);
    return shade;
}

void CreviceShade::draw(const Canvas& canvas, const Camera& camera, double radius, double strength) {
    const auto number = [](GLuint program, const char* name, double value) {
        glUniform1f(glGetUniformLocation(program, name), static_cast<float>(value));
    };
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(array_.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, open_sky_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, canvas.depth.name());

    const auto use = [&](GLuint program) {
        glUseProgram(program);
        number(program, "nearest", camera.nearest);
        number(program, "farthest", camera.farthest);
        number(program, "radius", radius);
        glUniform1i(glGetUniformLocation(program, "perspective"), camera.perspective ? 1 : 0);
        glUniform1i(glGetUniformLocation(program, "depth"), 0);
    };
    const GLuint gather = gather_program_.name();
    use(gather);
    number(gather, "scale", camera.scale);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);

    const GLuint blur = blur_program_.name();
    use(blur);
    number(blur, "strength", strength);
    glUniform1i(glGetUniformLocation(blur, "sky"), 1);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

} // namespace tumble::render
