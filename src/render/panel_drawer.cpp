#include "render/panel_drawer.h"

#include <cstddef>
#include <imgui.h>

namespace tumble::render {

static const char* const panel_vertices = R"(#version 400 core
layout(location = 0) in vec2 place;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 color;
uniform vec2 size;
out vec2 where;
out vec4 paint;
void main() {
    where = texel;
    paint = color;
    gl_Position = vec4(2.0 * place.x / size.x - 1.0, 1.0 - 2.0 * place.y / size.y, 0.0, 1.0);
}
)";

static const char* const panel_fragments = R"(#version 400 core
in vec2 where;
in vec4 paint;
uniform sampler2D letters;
out vec4 shade;
void main() { shade = paint * texture(letters, where); }
)";

Result<PanelDrawer> PanelDrawer::open(ImFontAtlas& letters) {
    auto program = make_program(panel_vertices, panel_fragments);
    if (!program) {
        return program.problems();
    }
    PanelDrawer drawer;
    drawer.program_ = std::move(*program);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    letters.GetTexDataAsRGBA32(&pixels, &width, &height);
    drawer.letters_ = make_plain_texture(GL_RGBA8, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    drawer.corners_ = make_buffer();
    drawer.indices_ = make_buffer();
    drawer.array_ = make_vertex_array();
    glBindVertexArray(drawer.array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawer.corners_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, drawer.indices_.name());
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
    }
    const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, pos)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, uv)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, col)));
    return drawer;
}

void PanelDrawer::draw(const ImDrawData& data, int width, int height) {
    glUseProgram(program_.name());
    glUniform2f(glGetUniformLocation(program_.name(), "size"), static_cast<float>(width), static_cast<float>(height));
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, letters_.name());
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_SCISSOR_TEST);
    glBindVertexArray(array_.name());
    constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        upload(corners_, list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const ImVec4& clip = command.ClipRect;
            glScissor(static_cast<GLint>(clip.x), height - static_cast<GLint>(clip.w),
                      static_cast<GLsizei>(clip.z - clip.x), static_cast<GLsizei>(clip.w - clip.y));
            glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type,
                                     reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                                     static_cast<GLint>(command.VtxOffset));
        }
    }
    glDisable(GL_SCISSOR_TEST);
}

} // namespace tumble::render
