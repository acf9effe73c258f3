#include "render/patch_drawer.h"

#include <cstddef>
#include <vector>

namespace tumble::render {

static const char* const patch_vertex = R"(#version 400 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec4 color;
uniform vec2 size;
out vec4 paint;
void main() {
    paint = color;
    gl_Position = vec4(2.0 * place.x / size.x - 1.0, 1.0 - 2.0 * place.y / size.y, 0.0, 1.0);
}
)";

static const char* const patch_fragment = R"(#version 400 core
in vec4 paint;
out vec4 shade;
void main() { shade = paint; }
)";

namespace {

struct PatchCorner {
    float place[2]; // pixels
    float color[4];
};

} // namespace

Result<PatchDrawer> PatchDrawer::open() {
    auto program = make_program(patch_vertex, patch_fragment);
    if (!program) {
        return program.problems();
    }
    PatchDrawer drawer;
    drawer.program_ = std::move(*program);
    drawer.corners_ = make_buffer();
    drawer.array_ = make_vertex_array();
    glBindVertexArray(drawer.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.corners_.name());
    const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(PatchCorner), at(offsetof(PatchCorner, place)));
    glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(PatchCorner), at(offsetof(PatchCorner, color)));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    return drawer;
}

void PatchDrawer::draw(std::span<const Patch> patches, int width, int height) {
    std::vector<PatchCorner> corners;
    corners.reserve(6 * patches.size());
    for (const Patch& patch : patches) {
        const Eigen::Vector3f color = patch.color.cast<float>();
        for (const std::size_t k : {0, 1, 2, 0, 2, 3}) {
            const Eigen::Vector2f place = patch.corners[k].cast<float>();
            corners.push_back(
                {{place.x(), place.y()}, {color.x(), color.y(), color.z(), static_cast<float>(patch.opacity)}});
        }
    }
    glUseProgram(program_.name());
    glUniform2f(glGetUniformLocation(program_.name(), "size"), static_cast<float>(width), static_cast<float>(height));
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(array_.name());
    upload(corners_, corners.data(), corners.size() * sizeof(PatchCorner));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
    glEnable(GL_DEPTH_TEST);
}

} // namespace tumble::render
