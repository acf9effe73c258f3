#pragma once

#include "base/problem.h"
#include "render/camera.h"
#include "render/color_map.h"
#include "render/field.h"
#include "render/gl_objects.h"
#include "render/theme.h"
#include "render/ticks.h"

namespace tumble::render {

/// Draws fields: values, not colours, are interpolated, so that a pixel's colour is the legend's at its value.
class FieldDrawer {
public:
    static Result<FieldDrawer> open(const ColorMap& map, const Theme& theme);

    /// Into the canvas' samples. Triangles are seen from both sides and face by face; `lit` false: in the bare colours
    /// of the scale. Values beyond the span have its end's colour.
    void draw(const Field& field, const Span& span, const Camera& camera, const Canvas& canvas, bool lit);

private:
    void draw_lines(const Field& field, const Camera& camera, const Canvas& canvas);

    int colors_ = 0;
    Eigen::Vector3d ink_ = Eigen::Vector3d::Zero();
    GlObject surface_program_;
    GlObject line_program_;
    GlObject scale_; // texture: the colours along the scale
    GlObject buffer_;
    GlObject array_;
};

} // namespace tumble::render
