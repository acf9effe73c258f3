#include "render/pair_painter.h"

#include "render/gl_context.h"
#include "render/gl_objects.h"
#include "render/mark_key.h"
#include "render/overlay.h"
#include "render/paper.h"
#include "render/quantity.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Side by side, or for wide scenes one above the other. Both halves are of one size.
PairArrangement arrange(const scene::Render& settings, bool stacked) {
    PairArrangement all;
    Layout& layout = all.lettering;
    const double w = settings.width, h = settings.height;
    layout.unit = settings.paper ? letter_unit(*settings.paper) : std::max(0.68, std::min(w / 1280, h / 720));
    layout.column = false;
    const double pad = std::round(pair_gap * layout.unit), middle = std::round(w / 2);
    const double top = std::round(pad + label_height * layout.unit);
    const double bottom = std::round(h - pad - strip_height * layout.unit);
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
    layout.scale_bar = {pad, strip, pad + 0.2 * w, h - pad};
    layout.time = {w - pad - clock_width * layout.unit, strip + 0.5 * pad, w - pad, h - pad};
    const double legend = std::min(legend_width * layout.unit, layout.time.left - layout.scale_bar.right - 4 * pad);
    layout.legend = {(layout.scale_bar.right + layout.time.left - legend) / 2, strip - 0.5 * pad,
                     (layout.scale_bar.right + layout.time.left + legend) / 2, h - pad};
    return all;
}

/// Whichever shows a flat scene larger; scenes in space stand side by side.
PairArrangement arrange(const scene::Render& settings, const observe::FrameLayout& layout) {
    const PairArrangement beside = arrange(settings, false);
    if (layout.dimension != 2)
        return beside;
    const Eigen::Vector3d size =
        settings.view ? settings.view->hi - settings.view->lo : layout.domain_hi - layout.domain_lo;
    const auto zoom = [&](const Area& area) { return std::min(area.width() / size.x(), area.height() / size.y()); };
    const PairArrangement stacked = arrange(settings, true);
    return zoom(stacked.halves[0]) > zoom(beside.halves[0]) ? stacked : beside;
}

scene::Render of_half(scene::Render settings, const Area& half) {
    settings.width = static_cast<int>(half.width());
    settings.height = static_cast<int>(half.height());
    settings.plot = false;
    return settings;
}

} // namespace

struct PairPainter::Inside {
    GlContext context;
    scene::Render settings;
    std::array<std::string, 2> labels;
    Theme theme;
    ColorMap map;
    std::array<Quantity, 2> quantities; // of scenes that may differ in their dimension
    std::array<Painter, 2> painters;
    PairArrangement arrangement;
    std::optional<Canvas> canvas;
    std::optional<Overlay> overlay;

    ~Inside() {
        const GlContext::Current current(context);
        overlay.reset();
        canvas.reset();
    }
    [[nodiscard]] Legend legend_for(const observe::Frame& left, const observe::Frame& right) const;
};

Result<PairPainter> PairPainter::open(const scene::Render& settings, const Layouts& layouts,
                                      const std::array<std::string, 2>& labels) {
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
    PairArrangement arrangement = arrange(settings, *layouts[0]);
    const auto theme = theme_of(settings);
    auto context = GlContext::open();
    if (!context)
        return context.problems();
    const PainterOptions bare_half{.lettering = false, .unit = settings.paper ? arrangement.lettering.unit : 1};
    std::array<Result<Painter>, 2> painters{
        Painter::open(of_half(settings, arrangement.halves[0]), layouts[0], bare_half),
        Painter::open(of_half(settings, arrangement.halves[1]), layouts[1], bare_half)};
    for (const Result<Painter>& painter : painters)
        if (!painter)
            return painter.problems();
    std::array<Quantity, 2> quantities{*find_quantity(settings.color, layouts[0]->dimension),
                                       *find_quantity(settings.color, layouts[1]->dimension)};
    take_key(arrangement.lettering, painters[0]->mark_key().rows(), !quantities[0].label.empty());
    const ColorMap map = *map_of(settings, quantities[0], *theme);
    std::shared_ptr<Inside> inside(new Inside{*context,
                                              settings,
                                              labels,
                                              *theme,
                                              map,
                                              std::move(quantities),
                                              {std::move(*painters[0]), std::move(*painters[1])},
                                              arrangement,
                                              {},
                                              {}});
    const GlContext::Current current(inside->context);
    auto canvas = make_canvas(settings.width, settings.height, 1);
    auto overlay = Overlay::open(arrangement.lettering, *theme);
    if (!canvas || !overlay)
        return canvas ? overlay.problems() : canvas.problems();
    inside->canvas = std::move(*canvas);
    inside->overlay = std::move(*overlay);
    return PairPainter(std::move(inside));
}

void PairPainter::fit(const Eigen::AlignedBox3d& box) {
    for (Painter& painter : inside_->painters)
        painter.fit(box);
}

void PairPainter::foresee(std::size_t side, const observe::Frame& frame) {
    inside_->painters.at(side).foresee(frame);
}

Legend PairPainter::Inside::legend_for(const observe::Frame& left, const observe::Frame& right) const {
    const Span span{(*settings.range)[0], (*settings.range)[1]};
    Legend legend{quantities[0].label, quantities[0].unit, span, map};
    for (std::size_t side = 0; side < 2; ++side)
        for (const double value : values_of(quantities[side], side == 0 ? left : right)) {
            legend.below = legend.below || value < span.lo;
            legend.above = legend.above || value > span.hi;
        }
    return legend;
}

Picture PairPainter::draw(const observe::Frame& left, const observe::Frame& right) {
    Inside& in = *inside_;
    const std::array<Picture, 2> halves{in.painters[0].draw(left), in.painters[1].draw(right)};
    const Camera& camera = in.painters[0].camera();
    OverlayContent content;
    content.title = in.labels[0];
    content.headings = {{in.arrangement.second_label, in.labels[1]}};
    content.time = time_stamp(left.time, in.settings.every);
    content.legend = in.legend_for(left, right);
    content.key = in.painters[0].mark_key();
    content.now = left.time;
    content.pixels_per_metre = camera.pixels_per_metre(camera.target);
    content.scale_note = camera.perspective ? " at the centre" : "";
    for (int i = 0; i < 3; ++i)
        content.axes[static_cast<std::size_t>(i)] = {camera.axes(0, i), -camera.axes(1, i)};

    const GlContext::Current current(in.context);
    glViewport(0, 0, in.canvas->width, in.canvas->height);
    glBindFramebuffer(GL_FRAMEBUFFER, in.canvas->resolved.name());
    const Eigen::Vector3f back = in.theme.background.cast<float>();
    glClearColor(back.x(), back.y(), back.z(), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    in.overlay->draw(content, in.arrangement.lettering, in.canvas->width, in.canvas->height);
    Picture picture = read_picture(*in.canvas);
    for (std::size_t side = 0; side < 2; ++side)
        paste(halves[side], static_cast<int>(in.arrangement.halves[side].left),
              static_cast<int>(in.arrangement.halves[side].top), picture);
    picture.dots_per_metre = dots_per_metre(in.settings);
    return picture;
}

const std::array<Area, 2>& PairPainter::halves() const {
    return inside_->arrangement.halves;
}

} // namespace tumble::render
