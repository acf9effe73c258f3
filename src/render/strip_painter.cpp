#include "render/strip_painter.h"

#include "render/mark_key.h"
#include "render/paper.h"
#include "render/quantity.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tumble::render {

struct StripArrangement {
    Layout lettering;
    std::vector<Area> cells;
    int height = 0; // pixels
};

namespace {

// Units of 1 at 1280 x 720, as in layout.cpp.
constexpr double strip_gap = 12;
constexpr double strip_title = 28;
constexpr double strip_words = 26; // under each cell
constexpr double strip_panels = 68;
constexpr double strip_legend = 440;
constexpr double strip_note = 150;
constexpr double least_cell = 40; // pixels a side

/// What is left of a picture for one of `columns` x `rows` cells, pixels.
struct CellSize {
    double width = 0, height = 0;
};

double lettering_unit(const scene::Render& settings) {
    return settings.paper ? letter_unit(*settings.paper)
                          : std::max(0.68, std::min(settings.width / 1280.0, settings.height / 720.0));
}

double above_cells(const scene::Render& settings, const StripPlan& plan, double unit) {
    return settings.paper && plan.note.empty() ? 0 : strip_title * unit;
}

/// High enough for the key, pixels.
double panel_height(const scene::Render& settings, double unit) {
    return std::max(strip_panels, key_height(key_rows(settings.marks))) * unit;
}

CellSize cell_size(const scene::Render& settings, const StripPlan& plan, double unit, int columns, int rows) {
    const double gap = strip_gap * unit;
    const double outside = 3 * gap + above_cells(settings, plan, unit) + panel_height(settings, unit);
    return {std::floor((settings.width - gap * (columns + 1)) / columns),
            std::floor((settings.height - outside) / rows - strip_words * unit)};
}

double zoom_in(const scene::Render& settings, const Eigen::AlignedBox3d& box, const CellSize& cell) {
    if (cell.width < least_cell || cell.height < least_cell)
        return 0;
    const Camera camera = *make_camera(settings, box, {0, 0, cell.width, cell.height});
    return camera.pixels_per_metre(camera.target);
}

/// Pixels of a cell's height that the box does not need.
double spare_height(const scene::Render& settings, const Eigen::AlignedBox3d& box, const CellSize& cell) {
    if (settings.camera == "free" && settings.eye != settings.target)
        return 0;
    const Camera camera = *make_camera(settings, box, {0, 0, cell.width, cell.height});
    double top = cell.height, bottom = 0;
    for (int k = 0; k < 8; ++k) {
        const double y = camera.to_picture(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k))).y();
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    const double least = std::max(least_cell, std::ceil(1.08 * (bottom - top)));
    return std::max(0.0, std::floor(cell.height - least));
}

/// The number of columns that shows the box largest; of equals the smallest, whose rows are fullest.
int best_columns(const scene::Render& settings, const Eigen::AlignedBox3d& box, const StripPlan& plan, double unit) {
    int best = 1;
    double largest = -1;
    for (int columns = 1; columns <= plan.cells; ++columns) {
        const int rows = (plan.cells + columns - 1) / columns;
        const double zoom = zoom_in(settings, box, cell_size(settings, plan, unit, columns, rows));
        if (zoom > 1.001 * largest) {
            largest = zoom;
            best = columns;
        }
    }
    return best;
}

StripArrangement arrange_strip(const scene::Render& settings, const Eigen::AlignedBox3d& box, const StripPlan& plan) {
    const double unit = lettering_unit(settings), gap = strip_gap * unit;
    const int columns = plan.columns > 0 ? plan.columns : best_columns(settings, box, plan, unit);
    const int rows = (plan.cells + columns - 1) / columns;
    CellSize cell = cell_size(settings, plan, unit, columns, rows);
    StripArrangement all;
    if (zoom_in(settings, box, cell) == 0)
        return all;
    cell.height -= spare_height(settings, box, cell);
    Layout& layout = all.lettering;
    layout.unit = unit;
    layout.column = false;
    const double w = settings.width, title = above_cells(settings, plan, unit);
    layout.title = {gap, gap, w - gap, gap + title};
    if (!plan.note.empty()) {
        layout.title.right -= strip_note * unit;
        layout.time = {layout.title.right, gap, w - gap, gap + title};
    }
    double y = std::round(gap + title);
    for (int k = 0; k < plan.cells; ++k) {
        const double x = std::round(gap + (k % columns) * (cell.width + gap));
        all.cells.push_back({x, y, x + cell.width, y + cell.height});
        if (k % columns == columns - 1 || k == plan.cells - 1)
            y = std::round(y + cell.height + strip_words * unit);
    }
    const double bottom = y + gap + panel_height(settings, unit);
    all.height = static_cast<int>(bottom + gap);
    layout.scale_bar = {gap, bottom - strip_panels * unit, gap + std::min(0.4 * w, 260 * unit), bottom};
    const double left = layout.scale_bar.right + 2 * gap;
    layout.legend = {std::max(left, w - gap - strip_legend * unit), y + gap, w - gap, bottom};
    return all;
}

} // namespace

template <class Medium> struct StripPainterOf<Medium>::Inside {
    scene::Render settings;
    std::shared_ptr<const observe::FrameLayout> layout;
    Quantity quantity;
    typename Medium::Artist artist;
    StripArrangement arrangement;
    typename Medium::Sheet sheet;
    Legend legend;
    std::string note;

    std::vector<typename Medium::Work> drawn{};
    std::vector<std::string> words{};
    MarkKey key{}; // of all cells
};

template <class Medium>
Result<StripPainterOf<Medium>> StripPainterOf<Medium>::open(const scene::Render& wanted,
                                                            std::shared_ptr<const observe::FrameLayout> layout,
                                                            const Eigen::AlignedBox3d& box, const StripPlan& plan) {
    const scene::Render settings = Medium::settings_for(wanted);
    if (!settings.range)
        return Problem{.key = "render.range",
                       .what = "pictures in one strip need one range of colours",
                       .fix = "give the values at the ends of the colour scale"};
    const auto theme = theme_of(settings);
    auto quantity = find_quantity(settings.color, layout->dimension);
    if (!theme || !quantity)
        return (theme ? quantity.problems() : theme.problems());
    const auto map = map_of(settings, *quantity, *theme);
    const auto camera = make_camera(settings, box, {0, 0, 100, 100});
    if (!map || !camera)
        return (map ? camera.problems() : map.problems());
    StripArrangement arrangement = arrange_strip(settings, box, plan);
    if (arrangement.cells.empty())
        return Problem{.key = "render.width_px",
                       .what = fmt::format("{} pictures in one of {} x {} pixels would be too small to see anything",
                                           plan.cells, settings.width, settings.height),
                       .fix = "ask for fewer of them, or for a larger picture"};
    scene::Render of_cell = settings;
    of_cell.width = static_cast<int>(arrangement.cells[0].width());
    of_cell.height = static_cast<int>(arrangement.cells[0].height());
    of_cell.plot = false;
    auto artist = Medium::Artist::open(of_cell, layout, {.lettering = false, .unit = arrangement.lettering.unit});
    if (!artist)
        return artist.problems();
    artist->fit(box);
    take_key(arrangement.lettering, key_rows(settings.marks), !quantity->label.empty());
    auto sheet = Medium::Sheet::open(settings, arrangement.height, arrangement.lettering, *theme);
    if (!sheet)
        return sheet.problems();
    const Legend legend{quantity->label, quantity->unit, {(*settings.range)[0], (*settings.range)[1]}, *map};
    return StripPainterOf(
        std::shared_ptr<Inside>(new Inside{of_cell, std::move(layout), *quantity, std::move(*artist),
                                           std::move(arrangement), std::move(*sheet), legend, plan.note}));
}

template <class Medium> void StripPainterOf<Medium>::foresee(const observe::Frame& frame) {
    inside_->artist.foresee(frame);
}

template <class Medium> void StripPainterOf<Medium>::pass_over(const observe::Frame& frame) {
    inside_->artist.pass_over(frame);
}

template <class Medium> void StripPainterOf<Medium>::add(const observe::Frame& frame, const std::string& words) {
    Inside& in = *inside_;
    in.drawn.push_back(in.artist.draw(frame));
    in.words.push_back(words);
    MarkKey key = in.artist.mark_key();
    key.join(in.key);
    in.key = std::move(key);
    for (const double value : values_of(in.quantity, frame)) {
        in.legend.below = in.legend.below || value < in.legend.span.lo;
        in.legend.above = in.legend.above || value > in.legend.span.hi;
    }
}

template <class Medium> Result<Done> StripPainterOf<Medium>::cut(const scene::Box& clip) {
    inside_->settings.clip = clip;
    return inside_->artist.restyle(inside_->settings);
}

template <class Medium> typename Medium::Work StripPainterOf<Medium>::finish() {
    Inside& in = *inside_;
    OverlayContent content;
    content.title = in.settings.paper ? "" : in.layout->title;
    content.legend = in.legend;
    content.key = in.key;
    content.look_with(in.artist.camera());
    for (std::size_t k = 0; k < in.drawn.size(); ++k) {
        Area under = in.arrangement.cells[k];
        under.top = under.bottom + 3 * in.arrangement.lettering.unit;
        content.captions.push_back({under, in.words[k]});
    }
    content.time = in.note;
    return in.sheet.put_together(in.drawn, in.arrangement.cells, content);
}

template <class Medium> const std::vector<Area>& StripPainterOf<Medium>::cells() const {
    return inside_->arrangement.cells;
}

template class StripPainterOf<Pixels>;
template class StripPainterOf<Lines>;

} // namespace tumble::render
