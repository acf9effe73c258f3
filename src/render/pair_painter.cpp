#include "render/pair_painter.h"

#include "render/clip.h"
#include "render/mark_key.h"
#include "render/paper.h"
#include "render/quantity.h"

#include <algorithm>
#include <cmath>

namespace tumble::render {

struct PairArrangement {
    Layout lettering; // title: the first label
    Area second_label;
    std::array<Area, 2> halves;
};

namespace {

// Units of 1 at 1280 x 720, as in layout.cpp.
constexpr double pair_gap = 16;
constexpr double label_height = 28;
constexpr double strip_height = 68;
constexpr double legend_width = 440;
constexpr double clock_width = 150;
constexpr int least_width = 480;
constexpr int least_height = 240;

/// Side by side, or for wide scenes one above the other. Both halves are of one size. The legend stands between scale
/// bar and time, or in a row of its own that is `above` units high. The key has `rows`.
PairArrangement arrange(const scene::Render& settings, int rows, bool stacked, double above) {
    // Of the strip's height the legend's place has less than all: half a gap.
    const double usual = std::max(strip_height, key_height(rows) + 0.5 * pair_gap);
    const double strip_units = above > 0 ? strip_height + above + pair_gap : usual;
    PairArrangement all;
    Layout& layout = all.lettering;
    const double w = settings.width, h = settings.height;
    layout.unit = settings.paper ? letter_unit(*settings.paper) : std::max(0.68, std::min(w / 1280, h / 720));
    layout.column = false;
    const double pad = std::round(pair_gap * layout.unit), middle = std::round(w / 2);
    const double top = std::round(pad + label_height * layout.unit);
    const double bottom = std::round(h - pad - strip_units * layout.unit);
    layout.title = {pad, pad, middle - pad, top};
    if (stacked) {
        const double each = std::floor((bottom - 2 * top) / 2), second = 2 * top + each;
        all.halves = {Area{pad, top, w - pad, top + each}, Area{pad, second, w - pad, second + each}};
        all.second_label = {pad, second - top + pad, w - pad, second};
    } else {
        all.halves = {Area{pad, top, middle - pad, bottom}, Area{middle + pad, top, w - pad, bottom}};
        all.second_label = {middle + pad, pad, w - pad, top};
    }
    const double strip = bottom + pad;
    if (above > 0) {
        const double row = strip - 0.5 * pad + above * layout.unit;
        layout.legend = {pad, strip - 0.5 * pad, w - pad, row};
        layout.time = {w - pad - clock_width * layout.unit, row + pad, w - pad, h - pad};
        layout.scale_bar = {pad, std::round(h - strip_height * layout.unit), pad + 0.4 * w, h - pad};
        return all;
    }
    layout.scale_bar = {pad, std::round(h - strip_height * layout.unit), pad + 0.2 * w, h - pad};
    layout.time = {w - pad - clock_width * layout.unit, strip + 0.5 * pad, w - pad, h - pad};
    const double legend = std::min(legend_width * layout.unit, layout.time.left - layout.scale_bar.right - 4 * pad);
    layout.legend = {(layout.scale_bar.right + layout.time.left - legend) / 2, strip - 0.5 * pad,
                     (layout.scale_bar.right + layout.time.left + legend) / 2, h - pad};
    return all;
}

/// Whichever shows a flat scene larger; scenes in space stand side by side.
PairArrangement arrange(const scene::Render& settings, const observe::FrameLayout& layout, double above) {
    const int rows = key_rows(settings, layout);
    const PairArrangement beside = arrange(settings, rows, false, above);
    if (layout.dimension != 2)
        return beside;
    const Eigen::Vector3d size =
        settings.view ? settings.view->hi - settings.view->lo : layout.domain_hi - layout.domain_lo;
    const auto zoom = [&](const Area& area) { return std::min(area.width() / size.x(), area.height() / size.y()); };
    const PairArrangement stacked = arrange(settings, rows, true, above);
    return zoom(stacked.halves[0]) > zoom(beside.halves[0]) ? stacked : beside;
}

/// For print with the legend in a row of its own where numbers or units would have no room beside it.
PairArrangement choose_arrangement(const scene::Render& settings,
                                   const std::array<std::shared_ptr<const observe::FrameLayout>, 2>& layouts,
                                   const Quantity& quantity, const ColorMap& map, const Theme& theme) {
    const int rows = key_rows(settings, *layouts[0]);
    const auto arranged = [&](double above) {
        PairArrangement tried = arrange(settings, *layouts[0], above);
        take_key(tried.lettering, rows, !quantity.label.empty());
        return tried;
    };
    PairArrangement usual = arranged(0);
    if (!settings.paper)
        return usual;
    const observe::FrameLayout& seen = *layouts[0];
    const Eigen::AlignedBox3d box = settings.view ? Eigen::AlignedBox3d(settings.view->lo, settings.view->hi)
                                                  : Eigen::AlignedBox3d(seen.domain_lo, seen.domain_hi);
    const auto readable = [&](const PairArrangement& tried) {
        const Area& half = tried.halves[0];
        if (!(half.width() >= 40 && half.height() >= 40)) // pixels
            return false;
        const Camera camera = *make_camera(settings, box, {0, 0, half.width(), half.height()});
        OverlayContent content;
        content.legend = {quantity.label, quantity.unit, {(*settings.range)[0], (*settings.range)[1]}, map};
        content.key = MarkMaker(settings.marks)
                          .key(seen, {camera, {}, 1, theme, clip_of(settings, seen), settings.clip_cuts})
                          .with_longest_words();
        content.look_with(camera);
        return is_readable(content, tried.lettering, theme);
    };
    const double high = std::max(strip_height, key_height(rows));
    if (!readable(usual))
        for (const double above : {high, high + 26}) // for a name in one line and in two
            if (PairArrangement tried = arranged(above); readable(tried))
                return tried;
    return usual;
}

scene::Render of_half(scene::Render settings, const Area& half) {
    settings.width = static_cast<int>(half.width());
    settings.height = static_cast<int>(half.height());
    settings.plot = false;
    return settings;
}

} // namespace

template <class Medium> struct PairPainterOf<Medium>::Inside {
    scene::Render settings;
    std::array<std::string, 2> labels;
    ColorMap map;
    std::array<Quantity, 2> quantities; // of scenes that may differ in their dimension
    std::array<typename Medium::Artist, 2> artists;
    PairArrangement arrangement;
    typename Medium::Sheet sheet;

    [[nodiscard]] Legend legend_for(const observe::Frame& left, const observe::Frame& right) const {
        const Span span{(*settings.range)[0], (*settings.range)[1]};
        Legend legend{quantities[0].label, quantities[0].unit, span, map};
        for (std::size_t side = 0; side < 2; ++side)
            for (const double value : values_of(quantities[side], side == 0 ? left : right)) {
                legend.below = legend.below || value < span.lo;
                legend.above = legend.above || value > span.hi;
            }
        return legend;
    }
};

template <class Medium>
Result<PairPainterOf<Medium>> PairPainterOf<Medium>::open(const scene::Render& wanted, const Layouts& layouts,
                                                          const std::array<std::string, 2>& labels) {
    const scene::Render settings = Medium::settings_for(wanted);
    if (settings.width < least_width || settings.height < least_height)
        return Problem{.key = "render.width_px",
                       .what = "two runs side by side need a picture of 480 x 240 pixels or more",
                       .fix = "write --size 1280x720, or larger"};
    if (!settings.range)
        return Problem{.key = "render.range",
                       .what = "two runs side by side need one range of colours",
                       .fix = "give the values at the ends of the colour scale"};
    if (settings.marks.arrows == "field" && !settings.marks.arrow_speed)
        return Problem{.key = "render.arrow_m_s",
                       .what = "two mean fields side by side need one scale of arrows",
                       .fix = "give the speed of the legend's arrow"};
    const auto theme = theme_of(settings);
    const auto quantity = find_quantity(settings.color, layouts[0]->dimension);
    if (!theme || !quantity)
        return theme ? quantity.problems() : theme.problems();
    const auto colors = map_of(settings, *quantity, *theme);
    const auto any_view = make_camera(settings, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, {0, 0, 100, 100});
    if (!colors || !any_view)
        return colors ? any_view.problems() : colors.problems();
    const PairArrangement arrangement = choose_arrangement(settings, layouts, *quantity, *colors, *theme);
    const PainterOptions bare_half{.lettering = false, .unit = arrangement.lettering.unit};
    std::array<Result<typename Medium::Artist>, 2> artists{
        Medium::Artist::open(of_half(settings, arrangement.halves[0]), layouts[0], bare_half),
        Medium::Artist::open(of_half(settings, arrangement.halves[1]), layouts[1], bare_half)};
    for (const auto& artist : artists)
        if (!artist)
            return artist.problems();
    std::array<Quantity, 2> quantities{*find_quantity(settings.color, layouts[0]->dimension),
                                       *find_quantity(settings.color, layouts[1]->dimension)};
    auto sheet = Medium::Sheet::open(settings, settings.height, arrangement.lettering, *theme);
    if (!sheet)
        return sheet.problems();
    return PairPainterOf(std::shared_ptr<Inside>(new Inside{settings,
                                                            labels,
                                                            *colors,
                                                            std::move(quantities),
                                                            {std::move(*artists[0]), std::move(*artists[1])},
                                                            arrangement,
                                                            std::move(*sheet)}));
}

template <class Medium> void PairPainterOf<Medium>::fit(const Eigen::AlignedBox3d& box) {
    for (auto& artist : inside_->artists)
        artist.fit(box);
}

template <class Medium> void PairPainterOf<Medium>::foresee(std::size_t side, const observe::Frame& frame) {
    inside_->artists.at(side).foresee(frame);
}

template <class Medium> void PairPainterOf<Medium>::expect_pace(double every) {
    for (auto& artist : inside_->artists)
        artist.expect_pace(every);
}

template <class Medium> void PairPainterOf<Medium>::pass_over(std::size_t side, const observe::Frame& frame) {
    inside_->artists.at(side).pass_over(frame);
}

template <class Medium>
typename Medium::Work PairPainterOf<Medium>::draw(const observe::Frame& left, const observe::Frame& right) {
    Inside& in = *inside_;
    std::vector<typename Medium::Work> halves;
    halves.push_back(in.artists[0].draw(left));
    halves.push_back(in.artists[1].draw(right));
    OverlayContent content;
    content.title = in.labels[0];
    content.headings = {{in.arrangement.second_label, in.labels[1]}};
    content.time = time_stamp(left.time, in.settings.every);
    content.legend = in.legend_for(left, right);
    content.key = in.artists[0].mark_key();
    content.key.join(in.artists[1].mark_key());
    content.now = left.time;
    content.look_with(in.artists[0].camera());
    return in.sheet.put_together(halves, in.arrangement.halves, content);
}

template <class Medium> const std::array<Area, 2>& PairPainterOf<Medium>::halves() const {
    return inside_->arrangement.halves;
}

template class PairPainterOf<Pixels>;
template class PairPainterOf<Lines>;

} // namespace tumble::render
