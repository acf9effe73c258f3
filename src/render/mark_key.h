#pragma once

#include "render/layout.h"
#include "render/marks.h"
#include "render/pen.h"
#include "render/theme.h"

namespace tumble::render {

/// Makes room for a key of so many rows beside or below the legend, or in its place where there is none; layout.key is
/// where it stands. Without rows nothing changes.
void take_key(Layout& layout, int rows, bool with_legend);

/// What the lines over the bodies mean, a row each, as many as fit: an arrow with its speed, a wedge that grows to the
/// thickness of a force, trails by name.
void draw_key(Pen& pen, const Area& area, const MarkKey& key, const Theme& theme);

} // namespace tumble::render
