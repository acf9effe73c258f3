#pragma once

#include "render/color_map.h"
#include "render/color_range.h"
#include "render/quantity.h"
#include "render/theme.h"
#include "scene/scene.h"

namespace tumble::render {

/// What a picture shows of a frame: settled by words that may be wrong.
struct Style {
    Theme theme;
    Quantity quantity;
    ColorMap map;
    ColorRange range;

    /// Bodies are all alike and pale, and there is no legend of colours.
    [[nodiscard]] bool plain() const { return quantity.label.empty(); }
};

/// For scenes of that dimension (2 or 3). Problems: an unknown camera, projection, quantity, colour map or background;
/// a range that holds nothing.
Result<Style> find_style(const scene::Render& settings, int dimension);

} // namespace tumble::render
