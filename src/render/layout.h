#pragma once

#include "render/area.h"

#include <functional>

namespace tumble::render {

/// Where everything stands in a picture. Areas do not overlap and lie wholly inside.
struct Layout {
    double unit = 1;      // pixels; lengths of lettering and gaps are multiples of it, 1 at 1280 x 720
    bool lettered = true; // false: the picture is too small to read anything, all of it belongs to the scene
    bool column = true;   // panels stand in a column on the right; false: below
    Area scene;           // what must be seen is fitted into this
    Area window;          // and what goes on beyond is cut off here, before it comes under the panels
    Area title;
    Area time;
    Area legend;
    Area key;  // of lines over the bodies; empty without them
    Area plot; // empty without a plot
    Area scale_bar;
};

/// The arrangement in which the scene is larger: a column, or below the scene a strip (two rows in an upright picture).
/// `zoom` tells how large the scene gets in an area (pixels a metre); `with_plot` reserves room for the plot. Below 320
/// x 200 pixels there is no lettering.
Layout make_layout(int width, int height, bool with_plot, const std::function<double(const Area&)>& zoom);

} // namespace tumble::render
