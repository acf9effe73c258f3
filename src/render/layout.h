#pragma once

#include "render/area.h"

#include <functional>
#include <optional>

namespace tumble::render {

/// Units, the heights of letters from their lowest to their highest reach.
constexpr double small_letters = 17;
constexpr double normal_letters = 19;
constexpr double large_letters = 23;

/// Of what typographers call the letters' size: hhea table of DejaVu Sans, ascent 1901 and descent 483 of 2048.
constexpr double ascent_of_letters = 1901.0 / 2048.0;
constexpr double reach_of_letters = (1901.0 + 483.0) / 2048.0;

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
/// x 200 pixels there is no lettering. `unit` (pixels) is chosen by the size where it is not given; below the scene the
/// legend's place is as high as a key of `key` units beside it. With `readable` the largest for which that holds: wider
/// columns, higher legends, and rows with the key under the legend are tried too; without one that is readable it is as
/// if nobody had asked.
Layout make_layout(int width, int height, bool with_plot, const std::function<double(const Area&)>& zoom,
                   std::optional<double> unit = {}, double key = 0,
                   const std::function<bool(const Layout&)>& readable = {});

/// Gives the title's place to the scene where nothing else stands beside it.
void leave_out_title(Layout& layout);

} // namespace tumble::render
