#include "render/mark_key.h"

#include "render/ticks.h"

#include <algorithm>
#include <fmt/core.h>

namespace tumble::render {

// Units; what is drawn of a mark, the gap to its words, the words.
constexpr double key_row = 22;
constexpr double key_sample = 44;
constexpr double key_gap = 8;
constexpr double key_words = 118;

void take_key(Layout& layout, int rows, bool with_legend) {
    if (rows == 0) {
        return;
    }
    if (!with_legend) {
        layout.key = layout.legend;
        layout.legend = {};
        return;
    }
    const double u = layout.unit;
    const double pad = 16 * u;
    Area& legend = layout.legend;
    if (layout.column) {
        const double top = legend.bottom - rows * key_row * u;
        layout.key = {legend.left, top, legend.right, legend.bottom};
        legend.bottom = top - pad;
    } else {
        const double right =
            std::min(legend.left + (key_sample + key_gap + key_words) * u, legend.left + 0.5 * legend.width());
        layout.key = {legend.left, legend.top, right, legend.bottom};
        legend.left = right + pad;
    }
}

static std::string amount(double value, const char* unit) {
    const DisplayUnit shown = display_unit(unit, {0, value});
    return fmt::format("{:.3g} {}", value * shown.factor, shown.unit);
}

static void draw_arrow(Pen& pen, double left, double y, double length, const Eigen::Vector3d& color) {
    const double u = pen.unit();
    const double head = std::min(9 * u, 0.5 * length);
    pen.line({left, y}, {left + length - head, y}, 2 * u, color);
    pen.triangle({left + length - head, y - 3.7 * u}, {left + length, y}, {left + length - head, y + 3.7 * u}, color);
}

void draw_key(Pen& pen, const Area& area, const MarkKey& key, const Theme& theme) {
    const double u = pen.unit();
    const double line = pen.height(Lettering::small);
    const double words = area.left + (key_sample + key_gap) * u;
    double y = area.top + 0.5 * key_row * u;
    const auto next = [&](const std::string& text) {
        pen.text(words, y - 0.5 * line, pen.shortened(text, Lettering::small, area.right - words), Lettering::small,
                 Align::left, theme.text);
        y += key_row * u;
    };
    if (key.arrow) {
        draw_arrow(pen, area.left, y, key.arrow->length, theme.arrow);
        next(amount(key.arrow->speed, "m/s") + (key.arrow->mean ? ", mean" : ""));
    }
    if (key.chain) {
        const double half = 0.5 * key.chain->thickness;
        const double right = area.left + key_sample * u;
        pen.triangle({area.left, y}, {right, y - half}, {right, y + half}, theme.chain);
        next("0 to " + amount(key.chain->force, "N") + (key.chain->beyond ? " and up" : ""));
    }
    for (const MarkKey::Trail& trail : key.trails) {
        if (y > area.bottom) {
            return;
        }
        pen.line({area.left, y}, {area.left + key_sample * u, y}, 2.4 * u, trail.color);
        next(trail.name);
    }
}

} // namespace tumble::render
