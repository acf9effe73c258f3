#include "render/panels.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tumble::render {

using Eigen::Vector2d;

static void draw_bar(Pen& pen, const Area& bar, const Legend& legend, bool upright) {
    pen.ramp(bar, legend.map, upright);
    // Values beyond an end are seen at a point instead of a straight end.
    const double tip = 0.55 * (upright ? bar.width() : bar.height());
    const Eigen::Vector3d low = legend.map.at(0);
    const Eigen::Vector3d high = legend.map.at(1);
    if (upright) {
        const double x = 0.5 * (bar.left + bar.right);
        if (legend.above) {
            pen.triangle({bar.left, bar.top}, {x, bar.top - tip}, {bar.right, bar.top}, high);
        }
        if (legend.below) {
            pen.triangle({bar.left, bar.bottom}, {x, bar.bottom + tip}, {bar.right, bar.bottom}, low);
        }
        return;
    }
    const double y = 0.5 * (bar.top + bar.bottom);
    if (legend.above) {
        pen.triangle({bar.right, bar.top}, {bar.right + tip, y}, {bar.right, bar.bottom}, high);
    }
    if (legend.below) {
        pen.triangle({bar.left, bar.top}, {bar.left - tip, y}, {bar.left, bar.bottom}, low);
    }
}

static double widest(const Pen& pen, const std::vector<std::string>& labels) {
    double most = 0;
    for (const std::string& label : labels) {
        most = std::max(most, pen.width(label, Lettering::small));
    }
    return most;
}

Area draw_legend(Pen& pen, const Area& area, const Legend& legend, const Theme& theme, bool upright) {
    const double u = pen.unit();
    const DisplayUnit shown = display_unit(legend.unit, legend.span);
    const Span span{legend.span.lo * shown.factor, legend.span.hi * shown.factor};
    const double line = pen.height(Lettering::small);
    const double thick = std::round(20 * u);
    const double tip = std::round(0.55 * thick);
    const std::string name = shown.unit.empty() ? legend.label : fmt::format("{} [{}]", legend.label, shown.unit);
    pen.text(area.left, area.top, pen.shortened(name, Lettering::normal, area.width()), Lettering::normal, Align::left,
             theme.text);
    const double under_name = std::round(area.top + 1.35 * pen.height(Lettering::normal));
    Area bar;
    std::vector<double> ticks;
    if (upright) {
        bar = {std::round(area.left), under_name + tip, std::round(area.left) + thick,
               std::floor(area.bottom - std::max(tip, 0.5 * line))};
        ticks = ticks_in(span, static_cast<int>(bar.height() / (2.2 * line)));
    } else {
        ticks = ticks_in(span, 6);
        while (ticks.size() > 2 &&
               static_cast<double>(ticks.size()) * (widest(pen, tick_labels(ticks)) + line) > area.width()) {
            ticks = ticks_in(span, static_cast<int>(ticks.size()) - 1);
        }
        const double side = std::round(std::max(tip, 0.5 * widest(pen, tick_labels(ticks))));
        bar = {std::round(area.left) + side, under_name, std::floor(area.right) - side,
               std::round(std::min(under_name + thick, area.bottom - 1.5 * line))};
    }
    draw_bar(pen, bar, legend, upright);
    const std::vector<std::string> labels = tick_labels(ticks);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double share = (ticks[i] - span.lo) / (span.hi - span.lo);
        if (upright) {
            const double y = bar.bottom - share * bar.height();
            pen.line({bar.right + u, y}, {bar.right + 6 * u, y}, pen.hair(), theme.faint);
            pen.text(bar.right + 10 * u, y - 0.5 * line, labels[i], Lettering::small, Align::left, theme.text);
        } else {
            const double x = bar.left + share * bar.width();
            pen.line({x, bar.bottom + u}, {x, bar.bottom + 5 * u}, pen.hair(), theme.faint);
            pen.text(x, bar.bottom + 6 * u, labels[i], Lettering::small, Align::middle, theme.text);
        }
    }
    return bar;
}

/// The world's axes from their common root; one that points at the eye or away from it is left out.
static void draw_axes(Pen& pen, const Area& area, const std::array<Vector2d, 3>& axes, const Theme& theme) {
    const double line = pen.height(Lettering::small);
    Vector2d low = Vector2d::Zero();
    Vector2d high = Vector2d::Zero();
    for (const Vector2d& axis : axes) {
        low = low.cwiseMin(axis);
        high = high.cwiseMax(axis);
    }
    // The letters stand beyond the tips and take a line's height on each side.
    const Vector2d room{area.width() - 1.6 * line, area.height() - 1.6 * line};
    const double arm = std::max(
        std::min(room.x() / std::max(high.x() - low.x(), 0.2), room.y() / std::max(high.y() - low.y(), 0.2)), 0.0);
    const double drawn = std::min(arm, 0.62 * area.height());
    const Vector2d middle{0.5 * (area.left + area.right), 0.5 * (area.top + area.bottom)};
    const Vector2d root = middle - 0.5 * drawn * (low + high);
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        const double reach = axes[i].norm();
        if (reach < 0.15) {
            continue;
        }
        const Vector2d end = root + drawn * axes[i];
        pen.line(root, end, 1.6 * pen.unit(), theme.text);
        const Vector2d letter = end + 0.5 * line * axes[i] / reach;
        pen.text(letter.x(), letter.y() - 0.5 * line, names[i], Lettering::small, Align::middle, theme.text);
    }
}

double draw_scale_bar(Pen& pen, const Area& area, double pixels_per_metre, const std::string& note,
                      const std::array<Vector2d, 3>& axes, const Theme& theme) {
    const double u = pen.unit();
    const double line = pen.height(Lettering::small);
    const auto draw_axes_from = [&](double x) { draw_axes(pen, {x, area.top, area.right, area.bottom}, axes, theme); };
    const double axes_begin = area.right - 1.15 * area.height();
    const double left = std::round(area.left);
    const double room = area.width() - 1.45 * area.height();
    if (!(pixels_per_metre > 0) || !std::isfinite(pixels_per_metre) || room <= 4 * u) {
        draw_axes_from(axes_begin);
        return 0;
    }
    const double length = round_down(room / pixels_per_metre);
    const double pixels = length * pixels_per_metre;
    const DisplayUnit shown = display_unit("m", {0, length});
    const double y = area.bottom - 6 * u;
    const Area bar{left, std::round(y - 2 * u), left + pixels, std::round(y + 1.5 * u)};
    pen.rectangle(bar, theme.text, 1);
    for (const double x : {left, left + pixels}) {
        const double inside = x == left ? x : x - 2 * u;
        pen.rectangle({inside, bar.top - 4 * u, inside + 2 * u, bar.bottom + 3 * u}, theme.text, 1);
    }
    // Where there is no room for the note a sign says that the length does not hold everywhere.
    const std::string plain = fmt::format("{:.12g} {}", length * shown.factor, shown.unit);
    double text_room = area.width() - 1.2 * area.height(); // up to the axes, whatever the bar leaves
    const bool fits = pen.width(plain + note, Lettering::small) <= room;
    const std::string words = note.empty() || fits ? plain + note : "\u2248 " + plain;
    // Of a length that would be cut off the axes give away some of their room.
    const double more = std::clamp(pen.width(words, Lettering::small) - text_room, 0.0, 0.45 * area.height());
    draw_axes_from(axes_begin + more);
    text_room += more;
    pen.text(left, bar.top - 6 * u - line, pen.shortened(words, Lettering::small, text_room), Lettering::small,
             Align::left, theme.text);
    return length;
}

std::string time_stamp(double time, double every) {
    int digits = 2;
    while (digits < 7 && std::abs(every * std::pow(10, digits) - std::round(every * std::pow(10, digits))) > 1e-6) {
        ++digits;
    }
    return fmt::format("t = {}{:.{}f} s", time < 0 ? "\u2212" : "", std::abs(time), digits);
}

} // namespace tumble::render
