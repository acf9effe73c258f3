#include "render/panels.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <optional>

namespace tumble::render {

using Eigen::Vector2d;

static Span finite_span(const std::vector<double>& values, std::size_t count) {
    Span span{0, 0};
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (std::isfinite(values[i])) {
            span.lo = any ? std::min(span.lo, values[i]) : values[i];
            span.hi = any ? std::max(span.hi, values[i]) : values[i];
            any = true;
        }
    }
    return any ? span : Span{0, 1};
}

/// Room for all values with a round end; zero belongs to it unless the values keep far from it.
static Span value_axis(Span span) {
    if (span.lo > 0 && span.lo < 0.6 * span.hi) {
        span.lo = 0;
    }
    if (span.hi < 0 && span.hi > 0.6 * span.lo) {
        span.hi = 0;
    }
    const double width = span.hi - span.lo;
    const double least = 1e-9 * std::max(std::abs(span.lo), std::abs(span.hi));
    if (!(width > least)) {
        const double half = std::max(0.5 * std::abs(span.hi), 1e-12);
        return span.hi == 0 ? Span{0, 1} : Span{span.lo - half, span.hi + half};
    }
    const double step = round_up(width / 4);
    return {std::floor(span.lo / step + 1e-6) * step, std::ceil(span.hi / step - 1e-6) * step};
}

/// The curve up to now in stretches without gaps, at most a lowest and a highest point a pixel column.
static std::vector<std::vector<Vector2d>> stretches(const PlotLine& line, std::size_t count, double now,
                                                    const Span& times, const Span& values, const Area& box) {
    std::vector<std::vector<Vector2d>> parts(1);
    for (std::size_t i = 0; i < count && line.times[i] <= now * (1 + 1e-9) + 1e-12; ++i) {
        if (!std::isfinite(line.values[i]) || !std::isfinite(line.times[i])) {
            if (!parts.back().empty()) {
                parts.emplace_back();
            }
            continue;
        }
        const Vector2d p{box.left + (line.times[i] - times.lo) / (times.hi - times.lo) * box.width(),
                         box.bottom - (line.values[i] - values.lo) / (values.hi - values.lo) * box.height()};
        std::vector<Vector2d>& part = parts.back();
        const std::size_t n = part.size();
        const bool crowded = n >= 3 && std::floor(part[n - 1].x()) == std::floor(p.x()) &&
                             std::floor(part[n - 2].x()) == std::floor(p.x());
        if (!crowded) {
            part.push_back(p);
        } else if (p.y() < std::min(part[n - 1].y(), part[n - 2].y())) {
            part[part[n - 1].y() < part[n - 2].y() ? n - 1 : n - 2].y() = p.y();
        } else if (p.y() > std::max(part[n - 1].y(), part[n - 2].y())) {
            part[part[n - 1].y() > part[n - 2].y() ? n - 1 : n - 2].y() = p.y();
        }
    }
    return parts;
}

static void draw_axes(Pen& pen, const Area& box, const std::vector<double>& across, const Span& times,
                      const std::vector<double>& along, const Span& values, const Theme& theme) {
    const double u = pen.unit();
    const double line = pen.height(Lettering::small);
    const auto row = tick_labels(along);
    for (std::size_t i = 0; i < along.size(); ++i) {
        const double y = std::round(box.bottom - (along[i] - values.lo) / (values.hi - values.lo) * box.height()) + 0.5;
        pen.line({box.left, y}, {box.right, y}, pen.hair(), theme.faint, 0.35);
        pen.text(box.left - 6 * u, y - 0.5 * line, row[i], Lettering::small, Align::right, theme.text);
    }
    const auto column = tick_labels(across);
    for (std::size_t i = 0; i < across.size(); ++i) {
        const double x = std::round(box.left + (across[i] - times.lo) / (times.hi - times.lo) * box.width()) + 0.5;
        pen.line({x, box.bottom}, {x, box.bottom + 4 * u}, pen.hair(), theme.faint);
        pen.text(x, box.bottom + 5 * u, column[i], Lettering::small, Align::middle, theme.text);
    }
    pen.line({box.left, box.bottom + 0.5}, {box.right, box.bottom + 0.5}, pen.hair(), theme.faint);
}

/// The last value up to now; nothing before the first, and where it is not known.
static std::optional<double> present_value(const PlotLine& line, std::size_t count, double now) {
    const auto end = line.times.begin() + static_cast<std::ptrdiff_t>(count);
    const auto after = std::upper_bound(line.times.begin(), end, now * (1 + 1e-9) + 1e-12);
    if (after == line.times.begin()) {
        return std::nullopt;
    }
    const double value = line.values[static_cast<std::size_t>(after - line.times.begin()) - 1];
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// With digits down to about a hundredth of the axis, as many at all times: what changes every picture must not jump.
static std::string value_words(double value, const Span& shown) {
    const double largest = std::max(std::abs(shown.lo), std::abs(shown.hi));
    const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 12);
    const std::string words = fmt::format("{:.{}f}", std::abs(value), digits);
    const bool is_zero = words.find_first_not_of("0.") == std::string::npos;
    return (value < 0 && !is_zero ? "\u2212" : "") + words;
}

/// "kinetic energy [mJ]" on the left, the present value on the right. Where there is no room the name gives way.
static void write_head(Pen& pen, const Area& area, const std::string& label, const std::string& unit,
                       const std::string& value, const Theme& theme) {
    const double taken = value.empty() ? 0 : pen.width(value, Lettering::small) + pen.height(Lettering::small);
    const double room = area.width() - taken;
    const std::string behind = unit.empty() ? "" : fmt::format(" [{}]", unit);
    const std::string name = pen.shortened(label, Lettering::small, room - pen.width(behind, Lettering::small));
    pen.text(area.left, area.top, pen.entire(name + behind, Lettering::small, room), Lettering::small, Align::left,
             theme.text);
    pen.text(area.right - 0.6 * pen.height(Lettering::small), area.top, value, Lettering::small, Align::right,
             theme.text);
}

void draw_plot(Pen& pen, const Area& area, const PlotLine& line, double now, const Theme& theme) {
    const double u = pen.unit();
    const double letter = pen.height(Lettering::small);
    const std::size_t count = std::min(line.times.size(), line.values.size());
    Span times = finite_span(line.times, count);
    times.hi = std::max({times.hi, now, line.until});
    times = count == 0 || !(times.hi > times.lo) ? Span{times.lo, times.lo + 1} : times;
    const Span found = finite_span(line.values, count);
    const bool all_zero = found.lo == 0 && found.hi == 0;
    const Span values = value_axis(found);
    const DisplayUnit time_unit = display_unit("s", times);
    const DisplayUnit unit = display_unit(line.unit, values);
    const Span shown_times{times.lo * time_unit.factor, times.hi * time_unit.factor};
    const Span shown{values.lo * unit.factor, values.hi * unit.factor};

    const auto present = present_value(line, count, now);
    write_head(pen, area, line.label, unit.unit, present && !all_zero ? value_words(*present * unit.factor, shown) : "",
               theme);
    Area box{area.left, area.top + 1.95 * letter, area.right - 0.6 * letter, area.bottom - 2.45 * letter};
    // Nothing but zeros has no scale; the 1 that such an axis ends at is no value worth a number.
    const auto along = all_zero ? std::vector<double>{0}
                                : ticks_in(shown, std::clamp(static_cast<int>(box.height() / (1.4 * letter)), 3, 6));
    double widest = 0;
    for (const std::string& label : tick_labels(along)) {
        widest = std::max(widest, pen.width(label, Lettering::small));
    }
    box.left = std::ceil(area.left + widest + 8 * u);
    auto across = ticks_in(shown_times, 6);
    const auto crowd = [&] {
        return static_cast<double>(across.size()) * (pen.width(tick_labels(across).back(), Lettering::small) + letter);
    };
    while (across.size() > 2 && crowd() > box.width()) {
        across = ticks_in(shown_times, static_cast<int>(across.size()) - 1);
    }
    draw_axes(pen, box, across, shown_times, along, shown, theme);
    pen.text(0.5 * (box.left + box.right), area.bottom - 1.1 * letter, fmt::format("time [{}]", time_unit.unit),
             Lettering::small, Align::middle, theme.text);
    const auto parts = stretches(line, count, now, times, values, box);
    for (const auto& part : parts) {
        pen.curve(part, 1.8 * u, theme.line);
    }
    if (!parts.back().empty()) {
        pen.dot(parts.back().back(), 3.2 * u, theme.line);
    }
}

} // namespace tumble::render
