#include "render/mark_key.h"

#include "render/clip.h"
#include "render/ticks.h"

#include <algorithm>
#include <fmt/core.h>
#include <functional>
#include <vector>

namespace tumble::render {

// Units; what is drawn of a mark, the gap to its words, the words.
constexpr double key_row = 22;
constexpr double key_sample = 44;
constexpr double key_gap = 8;
constexpr double key_words = 118;
constexpr double least_legend = 64; // in a column, for the colours above the key

int MarkKey::rows() const {
    const int of_trails = static_cast<int>(trails.size()) + (more_trails > 0 ? 1 : 0);
    return (arrow ? (arrow->mean ? 2 : 1) : 0) + (chain ? 1 : 0) + (of_trails > 0 ? of_trails + 1 : 0) +
           static_cast<int>(clip.size());
}

void MarkKey::join(const MarkKey& other) {
    if (chain && other.chain) {
        chain->beyond = chain->beyond || other.chain->beyond;
    }
}

MarkKey MarkKey::with_longest_words() const {
    constexpr double some = 0.888; // m/s, N, where no frame has told yet
    constexpr double some_time = 88.88;
    MarkKey longest = *this;
    if (longest.arrow) {
        longest.arrow->speed = longest.arrow->speed > 0 ? longest.arrow->speed : some;
        longest.arrow->over = {0, some_time};
    }
    if (longest.chain) {
        longest.chain->force = longest.chain->force > 0 ? longest.chain->force : some;
        longest.chain->beyond = true;
    }
    return longest;
}

int key_rows(const scene::Marks& marks) {
    const MarkMaker maker(marks);
    const Camera camera{};
    const Theme theme{};
    return maker.key({}, {camera, {}, 1, theme, {}}).rows();
}

int key_rows(const scene::Render& settings, const observe::FrameLayout& layout) {
    const auto clip = clip_of(settings, layout);
    const std::size_t rows = clip ? clip_words(*clip, settings.clip_cuts, layout).size() : 0;
    return key_rows(settings.marks) + static_cast<int>(rows);
}

double key_height(int rows) {
    return rows * key_row;
}

double key_width() {
    return key_sample + key_gap + key_words;
}

void take_key(Layout& layout, int rows, bool with_legend) {
    if (rows == 0 || (with_legend && layout.key.width() > 0)) {
        return; // or it has a place already
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
        const double room = std::max(legend.height() - least_legend * u - pad, 0.0);
        const double top = legend.bottom - std::min(key_height(rows) * u, room);
        layout.key = {legend.left, top, legend.right, legend.bottom};
        legend.bottom = top - pad;
    } else {
        const double right = std::min(legend.left + key_width() * u, legend.left + 0.5 * legend.width());
        layout.key = {legend.left, legend.top, right, legend.bottom};
        legend.left = right + pad;
    }
}

static std::string amount(double value, const char* unit) {
    const DisplayUnit shown = display_unit(unit, {0, value});
    return fmt::format("{:.3g} {}", value * shown.factor, shown.unit);
}

static std::string time_of(const Span& over) {
    return over.lo == over.hi ? fmt::format("t = {:.4g} s", over.lo)
                              : fmt::format("t = {:.4g} to {:.4g} s", over.lo, over.hi);
}

static void draw_arrow(Pen& pen, double left, double y, double length, const Eigen::Vector3d& color) {
    const double u = pen.unit();
    const double head = std::min(9 * u, 0.5 * length);
    pen.line({left, y}, {left + length - head, y}, 2 * u, color);
    pen.triangle({left + length - head, y - 3.7 * u}, {left + length, y}, {left + length - head, y + 3.7 * u}, color);
}

/// With fewer of the trails named where there are not so many rows.
static MarkKey fitted(MarkKey key, int rows) {
    for (; key.rows() > rows && !key.trails.empty(); key.trails.pop_back()) {
        ++key.more_trails;
        key.more_color.reset();
    }
    return key;
}

void draw_key(Pen& pen, const Area& area, const MarkKey& key, const Theme& theme) {
    struct Row {
        std::string words;
        std::function<void(double)> sample{}; // at that height
        bool is_name = false;
    };
    const double u = pen.unit();
    const double right = area.left + key_sample * u;
    const auto fit = static_cast<std::size_t>(std::max(area.height() / (key_row * u) + 0.1, 0.0));
    const MarkKey shown = fitted(key, static_cast<int>(fit));
    std::vector<Row> rows;
    if (shown.arrow) {
        rows.push_back({amount(shown.arrow->speed, "m/s") + (shown.arrow->mean ? ", mean" : ""),
                        [&](double y) { draw_arrow(pen, area.left, y, shown.arrow->length, theme.arrow); }});
        if (shown.arrow->mean) {
            rows.push_back({time_of(shown.arrow->over)});
        }
    }
    if (shown.chain) {
        const double half = 0.5 * shown.chain->thickness;
        rows.push_back({(shown.chain->beyond ? "0 to ≥ " : "0 to ") + amount(shown.chain->force, "N"),
                        [&pen, &area, &theme, right, half](double y) {
                            pen.triangle({area.left, y}, {right, y - half}, {right, y + half}, theme.chain);
                        }});
    }
    const auto line_of = [&](const Eigen::Vector3d& color) {
        return [&pen, &area, right, u, color](double y) { pen.line({area.left, y}, {right, y}, 2.4 * u, color); };
    };
    for (const MarkKey::Trail& trail : shown.trails) {
        rows.push_back({trail.name, line_of(trail.color), true});
    }
    if (shown.more_trails > 0) {
        rows.push_back({fmt::format("and {} more", shown.more_trails)});
        if (shown.more_color) {
            rows.back().sample = line_of(*shown.more_color);
        }
    }
    if (shown.since) {
        rows.push_back({fmt::format("since t = {:.4g} s", *shown.since)});
    }
    for (const std::string& words : shown.clip) {
        rows.push_back({words});
    }
    if (rows.size() > fit) {
        pen.note_crowded(rows[fit].words, static_cast<double>(fit) / static_cast<double>(rows.size()));
        rows.resize(fit);
    }
    const bool any_sample = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.sample != nullptr; });
    const double line = pen.height(Lettering::small);
    double y = area.top + 0.5 * key_row * u;
    for (const Row& row : rows) {
        if (row.sample) {
            row.sample(y);
        }
        // Without a sample in line with the others' words where it fits so.
        const double beside = any_sample ? right + key_gap * u : area.left;
        const bool wide = !row.sample && beside + pen.width(row.words, Lettering::small) > area.right;
        const double left = wide ? area.left : beside;
        const double room = area.right - left;
        pen.text(left, y - 0.5 * line,
                 row.is_name ? pen.shortened(row.words, Lettering::small, room)
                             : pen.entire(row.words, Lettering::small, room),
                 Lettering::small, Align::left, theme.text);
        y += key_row * u;
    }
}

} // namespace tumble::render
