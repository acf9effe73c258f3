#pragma once

#include "render/area.h"
#include "render/color_map.h"
#include "render/pen.h"
#include "render/plot_line.h"
#include "render/theme.h"
#include "render/ticks.h"

#include <Eigen/Core>
#include <array>
#include <string>

/// The parts of the lettering, each drawn wholly inside its area.
namespace tumble::render {

struct Legend {
    std::string label;
    std::string unit; // SI
    Span span;        // in unit
    ColorMap map;
    bool below = false; // values lie below the span: its end gets a point
    bool above = false;
    std::string note{}; // beside the name, as the largest value where it lies beyond the span
};

/// Label and unit over a colour bar with ticks; upright with the ticks on its right, or lying with the ticks below.
/// Returns the area of the bar itself: its colour at a share of its length is the map's at that share.
Area draw_legend(Pen& pen, const Area& area, const Legend& legend, const Theme& theme, bool upright);

/// The measure up to `now` (s) in axes that hold all of it, with the present value beside the label.
void draw_plot(Pen& pen, const Area& area, const PlotLine& line, double now, const Theme& theme);

/// The world's axes as the camera sees them and a bar of a round length with that length. `right` and `up`: pixels that
/// each axis' unit vector goes. Returns the bar's length in m, 0 where no round length fits.
double draw_scale_bar(Pen& pen, const Area& area, double pixels_per_metre, const std::string& note,
                      const std::array<Eigen::Vector2d, 3>& axes, const Theme& theme);

/// "t = 1.24 s" with as many digits as frames every `every` seconds need.
std::string time_stamp(double time, double every);

} // namespace tumble::render
