#pragma once

#include "render/layout.h"
#include "render/marks.h"
#include "render/pen.h"
#include "render/theme.h"

namespace tumble::render {

/// Units that a panel of so many rows of the key is high.
double key_height(int rows);

/// Units that it is wide where there is room.
double key_width();

/// Makes room for a key of so many rows beside or below the legend, or in its place where there is none; layout.key is
/// where it stands. Without rows nothing changes.
void take_key(Layout& layout, int rows, bool with_legend);

/// What the lines over the bodies mean, a row each: an arrow with its speed, and the time of the mean where it is one;
/// a wedge that grows to the thickness of a force; trails by name, as many as fit, how many more, and since when; where
/// a clip cuts.
void draw_key(Pen& pen, const Area& area, const MarkKey& key, const Theme& theme);

} // namespace tumble::render
