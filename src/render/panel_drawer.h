#pragma once

#include "render/gl_objects.h"

struct ImDrawData;
struct ImFontAtlas;

namespace tumble::render {

/// Draws what Dear ImGui left to be drawn. Its own OpenGL code looks for a library this project does not load.
class PanelDrawer {
public:
    /// Moves the letters of the atlas into a texture.
    static Result<PanelDrawer> open(ImFontAtlas& letters);

    /// Into the bound framebuffer of that size (pixels).
    void draw(const ImDrawData& data, int width, int height);

private:
    GlObject program_;
    GlObject letters_;
    GlObject corners_;
    GlObject indices_;
    GlObject array_;
};

} // namespace tumble::render
