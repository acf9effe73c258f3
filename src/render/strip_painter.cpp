#include "render/strip_painter.h"

#include "render/clip.h"
#include "render/letters.h"
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

/// How the panels stand below the cells: all in one row, or the legend in a row of its own above the others, `legend`
/// units high; and how many rows the key has.
struct PanelPlan {
    int key = 0;
    bool rows = false;
    double legend = 0;
};

/// High enough for the key, pixels.
double last_row(const PanelPlan& panels, double unit) {
    return std::max(strip_panels, key_height(panels.key)) * unit;
}

double panel_height(const PanelPlan& panels, double unit) {
    return last_row(panels, unit) + (panels.rows ? panels.legend + strip_gap : 0) * unit;
}

/// Pixels that the widest caption needs, as letters are wide in drawings; on the screen they are a little wider.
double caption_width(const StripPlan& plan, double unit) {
    double widest = 0;
    for (const std::string& words : plan.captions)
        widest = std::max(widest, width_of_letters(words));
    return 1.03 * widest * normal_letters * unit / reach_of_letters;
}

CellSize cell_size(const scene::Render& settings, const StripPlan& plan, const PanelPlan& panels, double unit,
                   int columns) {
    const int rows = (plan.cells + columns - 1) / columns;
    const double gap = strip_gap * unit;
    const double outside = 3 * gap + above_cells(settings, plan, unit) + panel_height(panels, unit);
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

/// The number of columns that shows the box largest among those whose captions fit, or among all where none does; of
/// equals the smallest, whose rows are fullest.
int best_columns(const scene::Render& settings, const Eigen::AlignedBox3d& box, const StripPlan& plan,
                 const PanelPlan& panels, double unit) {
    int best = 1;
    double largest = -1;
    const double caption = caption_width(plan, unit);
    const bool any_fits = cell_size(settings, plan, panels, unit, 1).width >= caption;
    for (int columns = 1; columns <= plan.cells; ++columns) {
        const CellSize cell = cell_size(settings, plan, panels, unit, columns);
        const double zoom = zoom_in(settings, box, cell);
        if (zoom > 1.001 * largest && (!any_fits || cell.width >= caption)) {
            largest = zoom;
            best = columns;
        }
    }
    return best;
}

StripArrangement arrange_strip(const scene::Render& settings, const Eigen::AlignedBox3d& box, const StripPlan& plan,
                               const PanelPlan& panels) {
    const double unit = lettering_unit(settings), gap = strip_gap * unit;
    const int columns = plan.columns > 0 ? plan.columns : best_columns(settings, box, plan, panels, unit);
    CellSize cell = cell_size(settings, plan, panels, unit, columns);
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
    double y = std::floor(gap + title); // rows that were rounded up would not all fit
    for (int k = 0; k < plan.cells; ++k) {
        const double x = std::round(gap + (k % columns) * (cell.width + gap));
        all.cells.push_back({x, y, x + cell.width, y + cell.height});
        if (k % columns == columns - 1 || k == plan.cells - 1)
            y = std::floor(y + cell.height + strip_words * unit);
    }
    const double bottom = y + gap + panel_height(panels, unit);
    all.height = static_cast<int>(bottom + gap);
    layout.scale_bar = {gap, bottom - strip_panels * unit, gap + std::min(0.4 * w, 260 * unit), bottom};
    const double left = layout.scale_bar.right + 2 * gap;
    if (panels.rows) {
        layout.legend = {gap, y + gap, w - gap, y + gap + panels.legend * unit};
        if (panels.key > 0)
            layout.key = {left, bottom - last_row(panels, unit), w - gap, bottom};
    } else {
        layout.legend = {std::max(left, w - gap - strip_legend * unit), y + gap, w - gap, bottom};
        const double key_left = layout.legend.left - gap - key_width() * unit;
        if (panels.key > 0 && key_left >= left) // beside the legend, which keeps its room
            layout.key = {key_left, y + gap, layout.legend.left - gap, bottom};
    }
    return all;
}

/// Where the words under a cell stand.
Area under(Area cell, const Layout& lettering) {
    cell.top = cell.bottom + 3 * lettering.unit;
    return cell;
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
    std::vector<std::string> clip; // of all cells; what else each of them is cut to stands under it

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
    const int rows = key_rows(settings, *layout);
    const Legend legend{quantity->label, quantity->unit, {(*settings.range)[0], (*settings.range)[1]}, *map};
    const MarkKey key = MarkMaker(settings.marks)
                            .key(*layout, {*camera, {}, 1, *theme, clip_of(settings, *layout), settings.clip_cuts});
    const auto arranged = [&](const PanelPlan& panels) {
        StripArrangement tried = arrange_strip(settings, box, plan, panels);
        take_key(tried.lettering, rows, !quantity->label.empty());
        return tried;
    };
    const auto readable = [&](const StripArrangement& tried) {
        OverlayContent content;
        content.legend = legend;
        content.key = key.with_longest_words();
        content.time = plan.note;
        for (std::size_t k = 0; k < std::min(plan.captions.size(), tried.cells.size()); ++k)
            content.captions.push_back({under(tried.cells[k], tried.lettering), plan.captions[k]});
        content.look_with(*make_camera(settings, box, {0, 0, tried.cells[0].width(), tried.cells[0].height()}));
        return is_readable(content, tried.lettering, *theme);
    };
    StripArrangement arrangement = arranged({.key = rows});
    if (settings.paper && !arrangement.cells.empty() && !readable(arrangement))
        for (const double height : {strip_panels, strip_panels + 26}) // for a name in one line and in two
            if (StripArrangement tried = arranged({rows, true, height}); !tried.cells.empty() && readable(tried)) {
                arrangement = std::move(tried);
                break;
            }
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
    auto sheet = Medium::Sheet::open(settings, arrangement.height, arrangement.lettering, *theme);
    if (!sheet)
        return sheet.problems();
    return StripPainterOf(
        std::shared_ptr<Inside>(new Inside{of_cell, std::move(layout), *quantity, std::move(*artist),
                                           std::move(arrangement), std::move(*sheet), legend, plan.note, key.clip}));
}

template <class Medium> void StripPainterOf<Medium>::foresee(const observe::Frame& frame) {
    inside_->artist.foresee(frame);
}

template <class Medium> void StripPainterOf<Medium>::expect_pace(double every) {
    inside_->artist.expect_pace(every);
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
    content.key.clip = in.clip;
    content.look_with(in.artist.camera());
    for (std::size_t k = 0; k < in.drawn.size(); ++k) {
        content.captions.push_back({under(in.arrangement.cells[k], in.arrangement.lettering), in.words[k]});
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
