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

/// The label, then its unit, in as many lines as they need; a unit stays whole.
static std::vector<std::string> name_lines(const Pen& pen, const std::string& label, const std::string& unit,
                                           double room) {
    std::vector<std::string> lines(1);
    const auto add = [&](const std::string& word) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || pen.width(longer, Lettering::normal) <= room) {
            lines.back() = longer;
        } else {
            lines.push_back(word);
        }
    };
    std::size_t from = 0;
    for (std::size_t to = label.find(' '); to != std::string::npos; from = to + 1, to = label.find(' ', from)) {
        add(label.substr(from, to - from));
    }
    add(label.substr(from));
    if (!unit.empty()) {
        add("[" + unit + "]");
    }
    return lines;
}

/// Three digits, as an end of a scale that no round number meets is written.
static double readable(double value) {
    if (value == 0) {
        return 0;
    }
    const double power = std::pow(10, 2 - std::floor(std::log10(std::abs(value))));
    return std::round(value * power) / power;
}

/// Ticks with one at each end of the scale; those nearer to an end than a share of the whole give way to it.
static std::vector<double> ticks_to_the_ends(const Span& span, int most, double nearest) {
    std::vector<double> ticks = ticks_in(span, most);
    const double width = span.hi - span.lo;
    const auto is_met = [&](double tick, double end) { return std::abs(tick - end) <= 1e-6 * width; };
    if (!ticks.empty() && !is_met(ticks.front(), span.lo)) {
        std::erase_if(ticks, [&](double tick) { return tick - span.lo < nearest * width; });
        ticks.insert(ticks.begin(), span.lo);
    }
    if (!ticks.empty() && !is_met(ticks.back(), span.hi)) {
        std::erase_if(ticks, [&](double tick) { return tick != span.lo && span.hi - tick < nearest * width; });
        ticks.push_back(span.hi);
    }
    return ticks;
}

static std::vector<std::string> end_labels(const std::vector<double>& ticks, const Span& span) {
    std::vector<double> round = ticks;
    for (double& tick : round) {
        tick = tick == span.lo || tick == span.hi ? readable(tick) : tick;
    }
    return tick_labels(round);
}

Area draw_legend(Pen& pen, const Area& area, const Legend& legend, const Theme& theme, bool upright) {
    const double u = pen.unit();
    const DisplayUnit shown = display_unit(legend.unit, legend.span);
    const Span span{legend.span.lo * shown.factor, legend.span.hi * shown.factor};
    const double line = pen.height(Lettering::small);
    const double thick = std::round(20 * u);
    const double tip = std::round(0.55 * thick);
    double under_name = area.top;
    for (const std::string& words : name_lines(pen, legend.label, shown.unit, area.width())) {
        pen.text(area.left, under_name, pen.entire(words, Lettering::normal, area.width()), Lettering::normal,
                 Align::left, theme.text);
        under_name = std::round(under_name + 1.35 * pen.height(Lettering::normal));
    }
    if (!upright && !legend.note.empty())
        pen.text(area.right, area.top, legend.note, Lettering::small, Align::right, theme.text);
    if (upright && !legend.note.empty())
        for (const std::string& words : name_lines(pen, legend.note, "", area.width())) {
            pen.text(area.left, under_name, pen.entire(words, Lettering::small, area.width()), Lettering::small,
                     Align::left, theme.text);
            under_name = std::round(under_name + 1.35 * line);
        }
    Area bar;
    std::vector<double> ticks;
    if (upright) {
        bar = {std::round(area.left), under_name + tip, std::round(area.left) + thick,
               std::floor(area.bottom - std::max(tip, 0.5 * line))};
        ticks = ticks_to_the_ends(span, static_cast<int>(bar.height() / (2.2 * line)), 1.2 * line / bar.height());
    } else {
        const auto wide = [&] { return widest(pen, end_labels(ticks, span)) + line; };
        for (int most = 6; most >= 2 && (most == 6 || wide() * static_cast<double>(ticks.size()) > area.width());
             --most) {
            ticks = ticks_in(span, most);
            ticks = ticks_to_the_ends(span, most, wide() / std::max(area.width() - wide(), 1.0));
        }
        const double side = std::round(std::max(tip, 0.5 * (wide() - line)));
        bar = {std::round(area.left) + side, under_name, std::floor(area.right) - side,
               std::round(std::min(under_name + thick, area.bottom - 1.5 * line))};
    }
    const std::vector<std::string> labels = end_labels(ticks, span);
    // Of a bar without room for its colours, or for its numbers side by side, nothing can be read.
    const double length = upright ? bar.height() : bar.width();
    const double needed = upright ? line : 0.5 * (widest(pen, {labels.front()}) + widest(pen, {labels.back()}) + line);
    if (length < needed) {
        pen.note_crowded(labels.front() + " to " + labels.back(), std::max(length, 0.0) / needed);
    }
    if (!upright && bar.height() < 0.25 * thick) {
        pen.note_crowded(legend.label, std::max(bar.bottom - area.top, 0.0) / (under_name + 0.25 * thick - area.top));
    }
    draw_bar(pen, bar, legend, upright);
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
        if (pixels_per_metre > 0 && room <= 4 * u) {
            pen.note_crowded("the scale bar", 0.5);
        }
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
    pen.text(left, bar.top - 6 * u - line, pen.entire(words, Lettering::small, text_room), Lettering::small,
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
