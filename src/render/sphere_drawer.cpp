#include "render/sphere_drawer.h"

#include <cstddef>

namespace tumble::render {

// Both shaders are compiled once a projection: what a parallel one spares is a third of a picture's time.
static const char* const sphere_vertices = R"(
layout(location = 0) in vec4 sphere;
layout(location = 1) in vec4 color;
uniform mat4 clip;
sample out vec3 offset;
flat out vec4 centre;
flat out vec3 paint;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
#ifdef PERSPECTIVE
    // Across the line from the eye, and as wide as the cone that touches the sphere is at its centre.
    float distance2 = dot(sphere.xyz, sphere.xyz);
    vec3 back = -sphere.xyz * inversesqrt(distance2);
    vec3 across = normalize(vec3(back.z, 0.0, -back.x));
    float reach = sphere.w * sqrt(distance2 / (distance2 - sphere.w * sphere.w));
    offset = reach * (corner.x * across + corner.y * cross(back, across));
#else
    offset = vec3(sphere.w * corner, 0.0);
#endif
    centre = sphere;
    paint = color.rgb;
    gl_Position = clip * vec4(sphere.xyz + offset, 1.0);
}
)";

static const char* const sphere_fragments = R"(
sample in vec3 offset;
flat in vec4 centre;
flat in vec3 paint;
uniform mat4 clip;
uniform float rim;
uniform float light; // 0: bare colours
out vec4 shade;
const vec3 lamp = vec3(-0.40, 0.66, 0.63);
void main() {
#ifdef PERSPECTIVE
    vec3 ray = normalize(centre.xyz + offset);
    vec3 nearest = offset - ray * dot(offset, ray);
#else
    const vec3 ray = vec3(0.0, 0.0, -1.0);
    vec3 nearest = vec3(offset.xy, 0.0);
#endif
    float half_chord2 = centre.w * centre.w - dot(nearest, nearest);
    if (half_chord2 < 0.0) discard;
    vec3 arm = nearest - ray * sqrt(half_chord2);
    float z = centre.z + arm.z;
#ifdef PERSPECTIVE
    gl_FragDepth = 0.5 - 0.5 * (clip[2].z + clip[3].z / z);
#else
    gl_FragDepth = 0.5 + 0.5 * (clip[2].z * z + clip[3].z);
#endif
    vec3 normal = arm / centre.w;
    float turned = 1.0 + dot(normal, ray);
    float gloss = max(dot(normal, normalize(lamp - ray)), 0.0);
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    gloss *= gloss;
    vec3 lit = paint * (0.49 + 0.10 * normal.y + 0.54 * max(dot(normal, lamp), 0.0)) +
               vec3(0.10 * gloss + rim * turned * turned);
    shade = vec4(mix(paint, lit, light), 1.0);
}
)";

static Result<GlObject> compile_for(const char* projection) {
    const std::string head = std::string("#version 400 core\n") + projection;
    return make_program(head + sphere_vertices, head + sphere_fragments);
}

Result<SphereDrawer> SphereDrawer::open() {
    auto parallel = compile_for("");
    auto perspective = compile_for("#define PERSPECTIVE\n");
    if (!parallel || !perspective) {
        return parallel ? perspective.problems() : parallel.problems();
    }
    SphereDrawer drawer;
    drawer.parallel_ = std::move(*parallel);
    drawer.perspective_ = std::move(*perspective);
    drawer.marks_ = make_buffer();
    drawer.array_ = make_vertex_array();
    glBindVertexArray(drawer.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.marks_.name());
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(SphereMark), nullptr);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SphereMark),
                          reinterpret_cast<const void*>(offsetof(SphereMark, color)));
    glVertexAttribDivisor(0, 1);
    glVertexAttribDivisor(1, 1);
    return drawer;
}

void SphereDrawer::draw(std::span<const SphereMark> marks, const Camera& camera, int width, int height, float rim,
                        bool lit) {
    const Eigen::Matrix4f clip = camera.clip_matrix(width, height);
    const GLuint program = camera.perspective ? perspective_.name() : parallel_.name();
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip"), 1, GL_FALSE, clip.data());
    glUniform1f(glGetUniformLocation(program, "rim"), rim);
    glUniform1f(glGetUniformLocation(program, "light"), lit ? 1.0F : 0.0F);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glBindVertexArray(array_.name());
    upload(marks_, marks.data(), marks.size_bytes());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(marks.size()));
}

} // namespace tumble::render
