#include "render/layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tumble::render {

constexpr double gap = 16;           // units between panels and to the edge
constexpr double title_height = 28;  // units
constexpr double bar_height = 58;    // units: axes, scale bar and its label
constexpr double legend_height = 64; // units, where it lies
constexpr double further_line = 26;  // units, of its name

static Layout in_column(double width, double height, double unit, bool with_plot, double least) {
    const double pad = std::round(gap * unit);
    const double panel = std::round(with_plot ? std::max({0.225 * width, 190 * unit, least * unit}) : least * unit);
    Layout layout;
    layout.unit = unit;
    const double left = width - pad - panel;
    const double right = width - pad;
    const double top = pad + title_height * unit;
    layout.title = {pad, pad, left - pad, top};
    layout.time = {left, pad, right, top};
    layout.scale_bar = {left, height - pad - bar_height * unit, right, height - pad};
    double below = layout.scale_bar.top - pad;
    if (with_plot) {
        layout.plot = {left, below - std::max(0.30 * height, 125 * unit), right, below};
        below = layout.plot.top - pad;
    }
    layout.legend = {left, top + 0.75 * pad, right, std::min(below, top + 0.75 * pad + 380 * unit)};
    layout.scene = {pad, top, left - pad, height - pad};
    layout.window = {0, top, left - 0.5 * pad, height};
    return layout;
}

static Layout in_strip(double width, double height, double unit, bool with_plot, double legend) {
    const double pad = std::round(gap * unit);
    Layout layout;
    layout.unit = unit;
    layout.column = false;
    const double usual = with_plot ? std::max(0.245 * height, 135 * unit) : 68 * unit;
    const double strip = legend > legend_height * unit ? std::max(usual, legend + 4 * unit) : usual;
    const double strip_top = height - pad - strip;
    const double top = pad + title_height * unit;
    const double clock = 150 * unit;
    layout.title = {pad, pad, width - 2 * pad - clock, top};
    layout.time = {width - pad - clock, pad, width - pad, top};
    const double bar_width = std::min(240 * unit, 0.27 * width);
    layout.scale_bar = {pad, height - pad - bar_height * unit, pad + bar_width, height - pad};
    const double plot_width = with_plot ? std::min(0.36 * width, 440 * unit) : 0;
    const double legend_left = layout.scale_bar.right + 2 * pad;
    const double legend_right = width - pad - (with_plot ? plot_width + 2 * pad : 0);
    layout.legend = {std::max(legend_left, legend_right - 440 * unit), height - pad - legend, legend_right,
                     height - pad};
    if (with_plot) {
        layout.plot = {width - pad - plot_width, strip_top, width - pad, height - pad};
    }
    layout.scene = {pad, top, width - pad, strip_top - 0.5 * pad};
    layout.window = {0, top, width, strip_top - 0.25 * pad};
    return layout;
}

/// For upright pictures: the legend over the plot and the scale bar.
static Layout in_rows(double width, double height, double unit, bool with_plot, double legend) {
    const double pad = std::round(gap * unit);
    Layout layout;
    layout.unit = unit;
    layout.column = false;
    const double top = pad + title_height * unit;
    const double clock = 150 * unit;
    layout.title = {pad, pad, width - 2 * pad - clock, top};
    layout.time = {width - pad - clock, pad, width - pad, top};
    const double bar_width = std::max(110 * unit, 0.27 * width);
    const double bottom = height - pad;
    layout.scale_bar = {width - pad - bar_width, bottom - bar_height * unit, width - pad, bottom};
    const double row = with_plot ? std::max(0.28 * height, 125 * unit) : bar_height * unit;
    if (with_plot) {
        layout.plot = {pad, bottom - row, layout.scale_bar.left - 2 * pad, bottom};
    }
    const double legend_bottom = bottom - row - pad;
    layout.legend = {pad, legend_bottom - legend, width - pad, legend_bottom};
    layout.scene = {pad, top, width - pad, layout.legend.top - 0.5 * pad};
    layout.window = {0, top, width, layout.legend.top - 0.25 * pad};
    return layout;
}

/// The key's `key` pixels stand beside the scale bar; what more they need is taken from the scene. With a plot there,
/// and without a key, nothing changes.
static Layout key_under_legend(Layout rows, double key) {
    if (rows.plot.width() > 0 || key <= 0) {
        return rows;
    }
    const double more = std::max(key - rows.scale_bar.height(), 0.0);
    const double pad = std::round(gap * rows.unit);
    for (double* edge : {&rows.legend.top, &rows.legend.bottom, &rows.scene.bottom, &rows.window.bottom}) {
        *edge -= more;
    }
    rows.key = {pad, rows.scale_bar.top - more, rows.scale_bar.left - 2 * pad, rows.scale_bar.bottom};
    return rows;
}

void leave_out_title(Layout& layout) {
    layout.title = {};
    if (layout.lettered && layout.column) {
        layout.scene.top = std::round(gap * layout.unit);
        layout.window.top = 0;
    }
}

Layout make_layout(int width, int height, bool with_plot, const std::function<double(const Area&)>& zoom,
                   std::optional<double> unit, double key, const std::function<bool(const Layout&)>& readable) {
    const double w = width;
    const double h = height;
    if (!unit && (width < 320 || height < 200)) {
        Layout bare;
        bare.lettered = false;
        bare.scene = {0, 0, w, h};
        bare.window = bare.scene;
        return bare;
    }
    // Below two thirds letters are hard to read; only pictures under 640 x 360, or 360 x 640, go there, as nothing else
    // would fit.
    const bool upright = h > w;
    const double share = upright ? std::min(w / 720, h / 1280) : std::min(w / 1280, h / 720);
    const double u = unit.value_or(share >= 0.5 ? std::max(share, 0.68) : 0.68 * share / 0.5);
    const Layout column = in_column(w, h, u, with_plot, key > 0 ? 170 : 150);
    const double legend = std::max(legend_height, key - 2) * u; // the last row ends a little above its end
    const Layout strip = upright ? in_rows(w, h, u, with_plot, legend) : in_strip(w, h, u, with_plot, legend);
    const Layout& usual = zoom(column.scene) >= zoom(strip.scene) ? column : strip;
    if (!readable || readable(usual)) {
        return usual;
    }
    std::vector<Layout> others{column, strip};
    for (const double panel : {190.0, 220.0, 250.0}) {
        others.push_back(in_column(w, h, u, with_plot, panel));
    }
    for (const double more : {0.0, further_line}) {
        others.push_back(in_strip(w, h, u, with_plot, legend + more * u));
        others.push_back(in_rows(w, h, u, with_plot, legend + more * u));
        others.push_back(key_under_legend(in_rows(w, h, u, with_plot, (legend_height + more) * u), key * u));
    }
    std::erase_if(others, [&](const Layout& layout) {
        return std::min(layout.scene.width(), layout.scene.height()) < 60 * u || !readable(layout);
    });
    const auto best = std::max_element(others.begin(), others.end(),
                                       [&](const Layout& a, const Layout& b) { return zoom(a.scene) < zoom(b.scene); });
    return best == others.end() ? usual : *best;
}

} // namespace tumble::render
