#include "render/field_drawer.h"

#include <cstddef>

namespace tumble::render {

using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

struct FieldCorner {
    Vector3f place; // m, view space
    float share;    // of the scale's length
};

const char* const field_vertex = R"(#version 400 core
layout(location = 0) in vec3 place;
layout(location = 1) in float share;
uniform mat4 clip;
out vec3 at;
out float where;
void main() {
    at = place;
    where = share;
    gl_Position = clip * vec4(place, 1.0);
}
)";

// A facet's own normal, from how its points move across the picture. Shades stay close to the scale's colours.
const char* const field_fragment = R"(#version 400 core
in vec3 at;
in float where;
uniform sampler2D scale;
uniform float colors;
uniform bool perspective;
uniform float light;
out vec4 shade;
void main() {
    float along = (clamp(where, 0.0, 1.0) * (colors - 1.0) + 0.5) / colors;
    vec3 paint = texture(scale, vec2(along, 0.5)).rgb;
    vec3 to_eye = perspective ? -normalize(at) : vec3(0.0, 0.0, 1.0);
    vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
    if (dot(normal, to_eye) < 0.0) normal = -normal;
    float lit = 0.80 + 0.20 * max(dot(normal, normalize(vec3(-0.40, 0.66, 0.63))), 0.0);
    shade = vec4(paint * mix(1.0, lit, light), 1.0);
}
)";

const char* const line_fragment = R"(#version 400 core
uniform vec4 ink;
out vec4 shade;
void main() { shade = ink; }
)";

constexpr float line_cover = 0.2F;
constexpr double line_nearer = 1e-3; // of the way to the eye, so that a line lies on its own surface

void set_matrix(GLuint program, const Camera& camera, const Canvas& canvas) {
    const Eigen::Matrix4f clip = camera.clip_matrix(canvas.width, canvas.height);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip"), 1, GL_FALSE, clip.data());
}

} // namespace

Result<FieldDrawer> FieldDrawer::open(const ColorMap& map, const Theme& theme) {
    auto surface = make_program(field_vertex, field_fragment);
    auto line = make_program(field_vertex, line_fragment);
    if (!surface || !line)
        return surface ? line.problems() : surface.problems();
    FieldDrawer drawer;
    drawer.colors_ = static_cast<int>(map.points.size());
    drawer.ink_ = theme.text;
    drawer.surface_program_ = std::move(*surface);
    drawer.line_program_ = std::move(*line);
    drawer.scale_ = make_texture();
    glBindTexture(GL_TEXTURE_2D, drawer.scale_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, drawer.colors_, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, map.points.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    drawer.buffer_ = make_buffer();
    drawer.array_ = make_vertex_array();
    glBindVertexArray(drawer.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.buffer_.name());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(FieldCorner), nullptr);
    glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, sizeof(FieldCorner),
                          reinterpret_cast<const void*>(offsetof(FieldCorner, share)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    return drawer;
}

void FieldDrawer::draw(const Field& field, const Span& span, const Camera& camera, const Canvas& canvas, bool lit) {
    std::vector<FieldCorner> corners;
    corners.reserve(3 * field.triangles.size());
    for (const auto& triangle : field.triangles)
        for (const int point : triangle) {
            const auto p = static_cast<std::size_t>(point);
            corners.push_back({camera.to_view(field.points[p]).cast<float>(),
                               static_cast<float>((field.values[p] - span.lo) / (span.hi - span.lo))});
        }
    const GLuint program = surface_program_.name();
    glUseProgram(program);
    set_matrix(program, camera, canvas);
    glUniform1f(glGetUniformLocation(program, "colors"), static_cast<float>(colors_));
    glUniform1i(glGetUniformLocation(program, "perspective"), camera.perspective ? 1 : 0);
    glUniform1f(glGetUniformLocation(program, "light"), lit ? 1.0F : 0.0F);
    glUniform1i(glGetUniformLocation(program, "scale"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, scale_.name());
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glBindVertexArray(array_.name());
    upload(buffer_, corners.data(), corners.size() * sizeof(FieldCorner));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
    draw_lines(field, camera, canvas);
}

void FieldDrawer::draw_lines(const Field& field, const Camera& camera, const Canvas& canvas) {
    std::vector<FieldCorner> ends;
    const double way = (camera.eye - camera.target).norm();
    for (const auto& line : field.lines)
        for (const int point : line) {
            Vector3d place = camera.to_view(field.points[static_cast<std::size_t>(point)]);
            place += line_nearer * (camera.perspective ? Vector3d(-place) : Vector3d(0, 0, way));
            ends.push_back({place.cast<float>(), 0});
        }
    const GLuint program = line_program_.name();
    glUseProgram(program);
    set_matrix(program, camera, canvas);
    const Vector3f ink = ink_.cast<float>();
    glUniform4f(glGetUniformLocation(program, "ink"), ink.x(), ink.y(), ink.z(), line_cover);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    upload(buffer_, ends.data(), ends.size() * sizeof(FieldCorner));
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(ends.size()));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

} // namespace tumble::render
