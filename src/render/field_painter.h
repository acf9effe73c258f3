#pragma once

#include "base/problem.h"
#include "observe/frame.h"
#include "render/camera.h"
#include "render/field.h"
#include "render/layout.h"
#include "render/picture.h"
#include "render/ticks.h"
#include "scene/scene.h"

#include <optional>
#include <string>

namespace tumble::render {

/// How a field is shown beside the settings of a scene, of which camera, colour map, background and size count, not
/// the bodies' quantity, range, clip and plot.
struct FieldLook {
    std::string title;
    std::string note;           // where a run's picture says the time
    std::string caption{};      // under the field
    std::string key{};          // in the key of colours, beside the quantity's name
    std::optional<Span> span{}; // of the colours, SI; without it they reach to the 98th percentile as in ColorRange
    bool lit = true;
    bool axes = true;  // false: the letters x, y, z would say nothing
    int part = -1;     // wall of the frame that the field stands for; it is not drawn
    double veil = 0.2; // opacity of bodies in front of the field; they are grey
};

/// A picture with all that says how to read it.
struct FieldPicture {
    Picture picture;
    Span span; // of the colours
    Camera camera;
    Layout layout;
    Area legend_bar; // pixels
};

/// Draws a field, among the bodies and walls of a frame where there is one. What must be in the picture is
/// settings.view or else the field. Problems: no points, a point or value that is not finite, an index out of range;
/// those of Painter::open about camera, colours, size and OpenGL.
Result<FieldPicture> paint_field(const scene::Render& settings, const Field& field, const FieldLook& look,
                                 const observe::Frame* around = nullptr);

} // namespace tumble::render
