#include "render/composition.h"

#include "render/clip.h"
#include "render/disc_list.h"
#include "render/mark_key.h"
#include "render/paper.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace tumble::render {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Outlines of discs, pixels at a picture's usual size; on small discs no more than this share of the smallest radius,
// which leaves 0.9^2 = 81 % of a disc in the legend's colour.
constexpr double usual_disc_line = 1.2;
constexpr double disc_line_share = 0.1;

Composition::Composition(const scene::Render& wanted, const PainterOptions& chosen,
                         std::shared_ptr<const observe::FrameLayout> scenery, Style shown)
    : settings(wanted), options(chosen), layout(std::move(scenery)), style(std::move(shown)), mark_maker(wanted.marks) {
    for (const observe::FrameShape& shape : layout->shapes) {
        double& farthest = reach.emplace_back(0);
        for (std::size_t s = 0; s < shape.centres.size(); ++s) {
            farthest = std::max(farthest, shape.centres[s].norm() + shape.radii[s]);
        }
        spokes.push_back(layout->dimension == 2 ? spoke_length(shape) : 0);
    }
}

AlignedBox3d Composition::box() const {
    return settings.view ? AlignedBox3d(settings.view->lo, settings.view->hi) : fitted;
}

void Composition::fit(const AlignedBox3d& more) {
    fitted.extend(more);
    arranged = false;
}

void Composition::settle_for(const observe::Frame& frame) {
    if (fitted.isEmpty()) {
        fit(bounds_of(frame));
    }
    if (!arranged) {
        arrange();
    }
}

/// Words about as wide as those of the frames to come, of which little is known yet.
OverlayContent Composition::expected_content(const Camera& seen) const {
    constexpr double some_time = 88.88; // s
    OverlayContent words;
    words.time = time_stamp(some_time, settings.every);
    const auto range = settings.range.value_or(std::array{0.0, 1.0});
    words.legend = {style.quantity.label, style.quantity.unit, {range[0], range[1]}, style.map};
    words.key = mark_maker.key(*layout, mark_view()).with_longest_words();
    words.look_with(seen);
    return words;
}

/// Settles panels and camera for what has been fitted.
void Composition::arrange() {
    const auto look = [&](const Area& area) { return *make_camera(settings, box(), area, 0, held); };
    // What a hand chose grows with the area's height alone: which arrangement is the better one it cannot tell.
    const std::optional<Held> of_shape = held && held->shape > 0 ? held : std::nullopt;
    const auto zoom = [&](const Area& area) {
        const Camera tried = *make_camera(settings, box(), area, 0, of_shape);
        return tried.pixels_per_metre(tried.target);
    };
    const int rows = key_rows(settings, *layout);
    if (settings.paper) {
        const auto readable = [&](Layout tried) {
            leave_out_title(tried);
            take_key(tried, rows, !style.plain());
            return is_readable(expected_content(look(tried.scene)), tried, style.theme);
        };
        arrangement = make_layout(settings.width, settings.height, settings.plot, zoom, letter_unit(*settings.paper),
                                  key_height(rows), readable);
    } else {
        arrangement = make_layout(settings.width, settings.height, settings.plot, zoom, {}, key_height(rows));
    }
    if (settings.paper) {
        leave_out_title(arrangement);
    }
    take_key(arrangement, rows, !style.plain());
    if (!options.lettering) {
        arrangement = Layout{};
        arrangement.lettered = false;
        arrangement.unit = options.unit;
        arrangement.scene = {0, 0, static_cast<double>(settings.width), static_cast<double>(settings.height)};
        arrangement.window = arrangement.scene;
    }
    camera = look(arrangement.scene);
    arranged = true;
}

Result<Done> Composition::restyle(const scene::Render& shown) {
    scene::Render wanted = shown;
    wanted.width = settings.width;
    wanted.height = settings.height;
    wanted.background = settings.background;
    wanted.paper = settings.paper;
    wanted.plot = settings.plot;
    auto found = find_style(wanted, layout->dimension);
    if (!found) {
        return found.problems();
    }
    if (wanted.color != settings.color || wanted.range != settings.range) {
        style.range = found->range; // else what an automatic range has seen goes on to count
    }
    const bool was_plain = style.plain();
    const int rows = key_rows(settings, *layout);
    style.quantity = found->quantity;
    style.map = found->map;
    settings = std::move(wanted);
    mark_maker.restyle(settings.marks);
    if (key_rows(settings, *layout) != rows || style.plain() != was_plain) {
        arranged = false; // their key takes or leaves room
    } else if (arranged) {
        camera = *make_camera(settings, box(), arrangement.scene, 0, held);
    }
    return Done{};
}

/// Nearest and farthest about all bodies and walls of this frame, wherever they have gone.
void Composition::enclose(const observe::Frame& frame) {
    AlignedBox3d all;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        if (frame.position[b].allFinite()) {
            const double r = reach[static_cast<std::size_t>(frame.shape[b])];
            all.extend(AlignedBox3d(frame.position[b].array() - r, frame.position[b].array() + r));
        }
    }
    for (std::size_t w = 0; w < layout->walls.size() && w < frame.walls.size(); ++w) {
        for (const Vector3d& vertex : layout->walls[w].vertices) {
            all.extend(frame.walls[w].rotation * vertex + frame.walls[w].translation);
        }
    }
    if (!all.isEmpty()) {
        camera.enclose(all);
    }
}

std::vector<std::uint32_t> Composition::colors_of(const observe::Frame& frame, Legend& legend) {
    const std::vector<double> values = values_of(style.quantity, frame);
    span = style.range.next(values, frame.time);
    legend = {style.quantity.label, style.quantity.unit, span, style.map};
    std::vector<std::uint32_t> colors;
    colors.reserve(values.size());
    for (const double value : values) {
        colors.push_back(style.map.bytes_at((value - span.lo) / (span.hi - span.lo)));
        legend.below = legend.below || value < span.lo;
        legend.above = legend.above || value > span.hi;
    }
    return colors;
}

std::vector<std::uint32_t> Composition::take_in(const observe::Frame& frame, Legend& legend) {
    settle_for(frame);
    if (settings.turn_deg_s != 0) {
        camera = *make_camera(settings, box(), arrangement.scene, frame.time, held);
    }
    enclose(frame);
    mark_maker.take_in(frame, mark_view());
    return colors_of(frame, legend);
}

OverlayContent Composition::content(const observe::Frame& frame, const PlotLine& plot, const Legend& legend) const {
    OverlayContent words;
    words.title = settings.paper ? "" : layout->title;
    words.time = time_stamp(frame.time, settings.every);
    words.legend = legend;
    words.key = mark_maker.key(*layout, mark_view());
    words.plot = settings.plot && !plot.label.empty() ? &plot : nullptr;
    words.now = frame.time;
    words.look_with(camera);
    return words;
}

Bare Composition::bareness(const observe::Frame& frame) const {
    const auto clip = clip_of(settings, *layout);
    const Area& window = arrangement.window;
    const bool corners = layout->dimension == 2 || (settings.view && settings.camera != "free");
    const Bare outside = corners ? Bare::out_of_corners : Bare::out_of_view;
    Bare bare = Bare::without_bodies;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const Vector3d& place = frame.position[b];
        if (!place.allFinite()) {
            continue;
        }
        const double radius = reach[static_cast<std::size_t>(frame.shape[b])];
        const bool kept = !clip || clip->exteriorDistance(place) <= (settings.clip_cuts ? radius : 0);
        bare = std::max(bare, kept ? outside : Bare::clipped_away);
        if (!kept || (camera.perspective && camera.to_view(place).z() >= 0)) {
            continue;
        }
        const Eigen::Vector2d seen = camera.to_picture(place);
        const double pixels = radius * camera.pixels_per_metre(place);
        if (seen.x() + pixels > window.left && seen.x() - pixels < window.right && seen.y() + pixels > window.top &&
            seen.y() - pixels < window.bottom) {
            return Bare::no;
        }
    }
    return bare;
}

MarkView Composition::mark_view() const {
    return {camera, arrangement.window, arrangement.unit, style.theme, clip_of(settings, *layout), settings.clip_cuts};
}

double Composition::disc_line() const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const observe::FrameShape& shape : layout->shapes) {
        for (const double radius : shape.radii) {
            smallest = std::min(smallest, radius);
        }
    }
    const double pixels = smallest * camera.pixels_per_metre(camera.target);
    return std::min(usual_disc_line * std::max(1.0, arrangement.unit), disc_line_share * pixels);
}

double Composition::wall_line() const {
    const double thickness = layout->dimension == 2 ? 2.0 : 1.0; // walls are nothing but their lines
    return thickness * std::max(1.2, 1.5 * arrangement.unit);
}

} // namespace tumble::render
