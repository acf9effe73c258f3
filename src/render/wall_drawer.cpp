#include "render/wall_drawer.h"

#include "render/wall_cut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tumble::render {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

// From this opacity on a wall hides what is behind it.
constexpr double opaque_from = 0.995;

struct WallDrawer::Corner {
    Vector3f place;  // m, view space
    Vector3f normal; // unit, view space
    float opacity = 1;
};

struct WallDrawer::Stroke {
    Vector3f from; // m, view space
    Vector3f to;
    Eigen::Vector2f beyond; // the ends, of half the thickness
};

static const char* const surface_vertex = R"(#version 400 core
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in float opacity;
uniform mat4 clip;
uniform vec4 faces[6]; // of the box that is shown, view space, positive inside
out float gl_ClipDistance[6];
centroid out vec3 at;
centroid out vec3 side;
out float cover;
void main() {
    at = place;
    side = normal;
    cover = opacity;
    for (int i = 0; i < 6; ++i) gl_ClipDistance[i] = dot(faces[i], vec4(place, 1.0));
    gl_Position = clip * vec4(place, 1.0);
}
)";

static const char* const surface_fragment = R"(#version 400 core
centroid in vec3 at;
centroid in vec3 side;
in float cover;
uniform vec3 tint;
uniform bool perspective;
uniform float nearest;
uniform float farthest;
layout(location = 0) out vec4 shade;
layout(location = 1) out float veil;
void main() {
    vec3 to_eye = perspective ? -normalize(at) : vec3(0.0, 0.0, 1.0);
    vec3 normal = normalize(side);
    if (dot(normal, to_eye) < 0.0) normal = -normal;
    float facing = clamp(dot(normal, to_eye), 0.12, 1.0);
    float light = 0.72 + 0.28 * dot(normal, vec3(-0.40, 0.66, 0.63)) / 0.63;
    veil = 1.0 - pow(1.0 - cover, 1.0 / facing);
    float far = clamp((-at.z - nearest) / (farthest - nearest), 0.0, 1.0);
    float weight = cover < 1.0 ? 0.02 + pow(1.0 - far, 3.0) : 1.0;
    shade = vec4(tint * clamp(light, 0.45, 1.15), 1.0) * veil * weight;
}
)";

static const char* const edge_vertex = R"(#version 400 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec2 beyond;
uniform mat4 clip;
uniform vec2 size;
uniform float thickness;
void main() {
    // A line that passes the eye is cut where it comes before it.
    const float least = 1e-6;
    vec4 a = clip * vec4(from, 1.0);
    vec4 b = clip * vec4(to, 1.0);
    if (a.w < least) a = mix(a, b, (least - a.w) / (b.w - a.w));
    if (b.w < least) b = mix(b, a, (least - b.w) / (a.w - b.w));
    vec2 along = (b.xy / b.w - a.xy / a.w) * size;
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 1) * 2.0 - 1.0);
    float end = (gl_VertexID >> 1) * 2.0 - 1.0;
    vec4 place = end < 0.0 ? a : b;
    // Longer at both ends, so that corners close; a little nearer, to lie on its own surface.
    float more = end < 0.0 ? beyond.x : beyond.y;
    place.xy += (across + more * end * along) * thickness / size * place.w;
    place.z -= 2e-4 * place.w;
    gl_Position = place;
}
)";

static const char* const edge_fragment = R"(#version 400 core
uniform vec4 ink;
out vec4 shade;
void main() { shade = ink; }
)";

static void set_clip(GLuint program, const Camera& camera, int width, int height) {
    const Eigen::Matrix4f clip = camera.clip_matrix(width, height);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip"), 1, GL_FALSE, clip.data());
}

Result<WallDrawer> WallDrawer::open(const observe::FrameLayout& layout, const Theme& theme, const Canvas& canvas) {
    auto surface = make_program(surface_vertex, surface_fragment);
    auto edge = make_program(edge_vertex, edge_fragment);
    auto veil = Veil::open(canvas);
    for (const Problems& found : {surface.problems(), edge.problems(), veil.problems()}) {
        if (!found.empty()) {
            return found;
        }
    }
    WallDrawer drawer;
    drawer.veil_ = std::move(*veil);
    for (const observe::FrameWall& wall : layout.walls) {
        drawer.surfaces_.push_back(make_wall_surface(wall));
        drawer.opacities_.push_back(std::clamp(wall.opacity, 0.0, 1.0));
    }
    drawer.theme_ = theme;
    drawer.surface_program_ = std::move(*surface);
    drawer.edge_program_ = std::move(*edge);
    const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    drawer.buffer_ = make_buffer();
    drawer.surface_array_ = make_vertex_array();
    glBindVertexArray(drawer.surface_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.buffer_.name());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), at(offsetof(Corner, place)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), at(offsetof(Corner, normal)));
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(Corner), at(offsetof(Corner, opacity)));
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
    }
    drawer.edge_buffer_ = make_buffer();
    drawer.edge_array_ = make_vertex_array();
    glBindVertexArray(drawer.edge_array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.edge_buffer_.name());
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Stroke), at(offsetof(Stroke, from)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Stroke), at(offsetof(Stroke, to)));
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, sizeof(Stroke), at(offsetof(Stroke, beyond)));
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    return drawer;
}

std::vector<WallDrawer::Corner> WallDrawer::collect(const observe::Frame& frame, const Camera& camera,
                                                    bool opaque) const {
    std::vector<Corner> corners;
    for (std::size_t w = 0; w < surfaces_.size() && w < frame.walls.size(); ++w) {
        if ((opacities_[w] >= opaque_from) != opaque || opacities_[w] == 0) {
            continue;
        }
        const observe::WallPlace& place = frame.walls[w];
        const Matrix3d turn = camera.axes * place.rotation;
        const Vector3d origin = camera.to_view(place.translation);
        const float opacity = opaque ? 1.0F : static_cast<float>(opacities_[w]);
        for (const WallSurface::Triangle& triangle : surfaces_[w].triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                corners.push_back({(origin + turn * triangle.corners[k]).cast<float>(),
                                   (turn * triangle.normals[k]).cast<float>(), opacity});
            }
        }
    }
    return corners;
}

std::vector<WallDrawer::Stroke> WallDrawer::collect_edges(const observe::Frame& frame, const Camera& camera) const {
    std::vector<Stroke> strokes;
    for (std::size_t w = 0; w < surfaces_.size() && w < frame.walls.size(); ++w) {
        const observe::WallPlace& place = frame.walls[w];
        const Matrix3d turn = camera.axes * place.rotation;
        const Vector3d origin = camera.to_view(place.translation);
        for (const WallSurface::Edge& edge : surfaces_[w].edges) {
            std::optional shown(std::array{0.0, 1.0});
            if (cut_) {
                shown = shares_within(*cut_, {place.rotation * edge.ends[0] + place.translation,
                                              place.rotation * edge.ends[1] + place.translation});
            }
            if (!shown) {
                continue;
            }
            const Vector3d from = origin + turn * edge.ends[0];
            const Vector3d to = origin + turn * edge.ends[1];
            const Vector3d to_eye = camera.perspective ? Vector3d(-from.normalized()) : Vector3d(Vector3d::UnitZ());
            const double one = (turn * edge.normals[0]).dot(to_eye);
            const double other = (turn * edge.normals[1]).dot(to_eye);
            // Seen exactly from its side a surface has no outline but its rims.
            const bool turns_away = one * other < 0 && std::max(std::abs(one), std::abs(other)) > 1e-3;
            if (edge.sharp || turns_away) {
                const auto at = [&](double share) {
                    return Vector3f((share == 0 ? from : share == 1 ? to : from + share * (to - from)).cast<float>());
                };
                strokes.push_back(
                    {at((*shown)[0]), at((*shown)[1]), Eigen::Vector2d(edge.beyond[0], edge.beyond[1]).cast<float>()});
            }
        }
    }
    if (cut_) {
        add_cut_lines(frame, camera, strokes);
    }
    return strokes;
}

void WallDrawer::add_cut_lines(const observe::Frame& frame, const Camera& camera, std::vector<Stroke>& strokes) const {
    for (std::size_t w = 0; w < surfaces_.size() && w < frame.walls.size(); ++w) {
        if (opacities_[w] == 0) {
            continue;
        }
        for (const Segment& line : cut_lines(surfaces_[w], frame.walls[w], *cut_)) {
            strokes.push_back({camera.to_view(line[0]).cast<float>(), camera.to_view(line[1]).cast<float>(),
                               Eigen::Vector2f::Constant(0.5F)});
        }
    }
}

/// The faces of a box as planes in view space, positive inside.
static Eigen::Matrix<float, 4, 6> cutting_planes(const Eigen::AlignedBox3d& box, const Camera& camera) {
    Eigen::Matrix<float, 4, 6> faces;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3d way = camera.axes.col(axis);
        const double eye = camera.eye[axis];
        faces.col(2 * axis) << way.cast<float>(), static_cast<float>(eye - box.min()[axis]);
        faces.col(2 * axis + 1) << -way.cast<float>(), static_cast<float>(box.max()[axis] - eye);
    }
    return faces;
}

/// While it lives the graphics library leaves out what lies beyond the faces.
struct FacesOn {
    bool on;
    explicit FacesOn(bool wanted) : on(wanted) {
        for (GLenum i = 0; on && i < 6; ++i) {
            glEnable(GL_CLIP_DISTANCE0 + i);
        }
    }
    FacesOn(const FacesOn&) = delete;
    FacesOn& operator=(const FacesOn&) = delete;
    ~FacesOn() {
        for (GLenum i = 0; on && i < 6; ++i) {
            glDisable(GL_CLIP_DISTANCE0 + i);
        }
    }
};

void WallDrawer::draw_surfaces(const std::vector<Corner>& corners, const Camera& camera, const Canvas& canvas) {
    const GLuint program = surface_program_.name();
    glUseProgram(program);
    set_clip(program, camera, canvas.width, canvas.height);
    const Vector3f tint = theme_.wall.cast<float>();
    glUniform3fv(glGetUniformLocation(program, "tint"), 1, tint.data());
    glUniform1i(glGetUniformLocation(program, "perspective"), camera.perspective ? 1 : 0);
    glUniform1f(glGetUniformLocation(program, "nearest"), static_cast<float>(camera.nearest));
    glUniform1f(glGetUniformLocation(program, "farthest"), static_cast<float>(camera.farthest));
    if (cut_) {
        const Eigen::Matrix<float, 4, 6> faces = cutting_planes(*cut_, camera);
        glUniform4fv(glGetUniformLocation(program, "faces"), 6, faces.data());
    }
    const FacesOn cut(cut_.has_value());
    glEnable(GL_DEPTH_TEST);
    glBindVertexArray(surface_array_.name());
    upload(buffer_, corners.data(), corners.size() * sizeof(Corner));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

void WallDrawer::draw_opaque(const observe::Frame& frame, const Camera& camera, const Canvas& canvas) {
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    draw_surfaces(collect(frame, camera, true), camera, canvas);
}

void WallDrawer::draw_translucent(const observe::Frame& frame, const Camera& camera, const Canvas& canvas,
                                  double line) {
    const std::vector<Corner> corners = collect(frame, camera, false);
    if (!corners.empty()) {
        veil_.begin(canvas);
        draw_surfaces(corners, camera, canvas);
        veil_.finish(canvas);
    }
    const std::vector<Stroke> strokes = collect_edges(frame, camera);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const GLuint program = edge_program_.name();
    glUseProgram(program);
    set_clip(program, camera, canvas.width, canvas.height);
    glUniform2f(glGetUniformLocation(program, "size"), static_cast<float>(canvas.width),
                static_cast<float>(canvas.height));
    glUniform1f(glGetUniformLocation(program, "thickness"), static_cast<float>(line));
    const Vector3f ink = theme_.edge.cast<float>();
    glUniform4f(glGetUniformLocation(program, "ink"), ink.x(), ink.y(), ink.z(), 0.85F);
    glBindVertexArray(edge_array_.name());
    upload(edge_buffer_, strokes.data(), strokes.size() * sizeof(Stroke));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(strokes.size()));
    glDepthMask(GL_TRUE);
}

} // namespace tumble::render
