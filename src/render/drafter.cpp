#include "render/drafter.h"

#include "render/body_outline.h"
#include "render/disc_list.h"
#include "render/drawing_pen.h"
#include "render/paper.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double fine_dpi = 720;    // ten pixels a point
constexpr double screen_dpi = 96;   // CSS: a pixel is 1/96 inch
constexpr double edge_share = 0.85; // of the edges' colour in walls, as Painter has it; the rest is the background's

scene::Render in_fine_pixels(const scene::Render& settings) {
    scene::Render fine = settings;
    if (fine.paper) {
        fine.paper->dpi = fine_dpi;
        fine.width = static_cast<int>(std::lround(fine.paper->width_mm / mm_per_inch * fine_dpi));
        fine.height = static_cast<int>(std::lround(fine.paper->height_mm / mm_per_inch * fine_dpi));
    }
    return fine;
}

Drawing blank_drawing(const scene::Render& settings, double height, const Theme& theme) {
    const double mm = mm_per_inch / (settings.paper ? settings.paper->dpi : screen_dpi);
    // Whole pixels are a little more or less than the paper.
    const bool full = settings.paper && height == settings.height;
    return {.width_mm = settings.paper ? settings.paper->width_mm : settings.width * mm,
            .height_mm = full ? settings.paper->height_mm : height * mm,
            .mm_per_pixel = mm,
            .background = theme.background,
            .shapes = {}};
}

Result<Drafter> Drafter::open(const scene::Render& settings, std::shared_ptr<const observe::FrameLayout> layout,
                              const PainterOptions& options) {
    if (layout->dimension != 2) {
        return Problem{.what =
                           "spheres in space cannot be drawn as lines: SVG and PDF are for scenes in two dimensions",
                       .fix = "draw pixels: a folder of PNG files, or one with --strip 1 and a name that ends in .png"};
    }
    auto style = find_style(settings, layout->dimension);
    if (!style) {
        return style.problems();
    }
    return Drafter(Composition(settings, options, std::move(layout), std::move(*style)));
}

void Drafter::foresee(const observe::Frame& frame) {
    page_.settle_for(frame);
    page_.mark_maker.foresee(frame, page_.mark_view());
}

void Drafter::pass_over(const observe::Frame& frame) {
    Legend legend;
    (void)page_.take_in(frame, legend);
}

Drawing Drafter::draw(const observe::Frame& frame, const PlotLine& plot) {
    Legend legend;
    const std::vector<std::uint32_t> colors = page_.take_in(frame, legend);
    Drawing drawing = blank_drawing(page_.settings, page_.settings.height, page_.style.theme);
    drawing.shapes.emplace_back(GroupBegin{"scene", Vector2d::Zero(), page_.arrangement.window});
    drawing.bare = page_.bareness(frame);
    add_bodies(frame, colors, drawing);
    add_walls(frame, drawing);
    add_marks(frame, drawing);
    drawing.shapes.emplace_back(GroupEnd{});
    if (page_.arrangement.lettered) {
        DrawingPen pen(drawing, page_.arrangement.unit);
        write_panels(pen, page_.content(frame, plot, legend), page_.arrangement, page_.style.theme);
        drawing.crowded = pen.crowded();
    }
    return drawing;
}

static Vector3d from_bytes(std::uint32_t color) {
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(color);
    return Vector3d(bytes[0], bytes[1], bytes[2]) / 255;
}

/// Each body once, with its line inside its rim; then the lines that turn with them.
void Drafter::add_bodies(const observe::Frame& frame, const std::vector<std::uint32_t>& colors,
                         Drawing& drawing) const {
    const Camera& camera = page_.camera;
    const double line = page_.disc_line();
    const bool plain = page_.style.plain();
    const Theme& theme = page_.style.theme;
    Look look{.ink = plain ? theme.plain_edge : theme.outline, .line = line};
    drawing.shapes.emplace_back(GroupBegin{.name = "bodies"});
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const observe::FrameShape& shape = page_.layout->shapes[static_cast<std::size_t>(frame.shape[b])];
        std::vector<Arc> discs;
        for (std::size_t d = 0; d < shape.radii.size(); ++d) {
            const Vector3d centre = frame.position[b] + frame.orientation[b] * shape.centres[d];
            const double radius = camera.pixels_per_metre(centre) * shape.radii[d];
            discs.push_back({camera.to_picture(centre), radius - 0.5 * line, 0, 0});
        }
        if (!std::all_of(discs.begin(), discs.end(), [](const Arc& disc) { return disc.centre.allFinite(); })) {
            continue;
        }
        look.fill = from_bytes(colors[b]);
        if (discs.size() == 1) {
            drawing.shapes.emplace_back(Circle{discs[0].centre, discs[0].radius, look});
        } else {
            drawing.shapes.emplace_back(ArcLoops{outline_of(discs), look});
        }
    }
    drawing.shapes.emplace_back(GroupEnd{});
    if (plain) {
        return; // pale bodies step back behind what is drawn over them
    }
    drawing.shapes.emplace_back(GroupBegin{.name = "turns"});
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const double length = page_.spokes[static_cast<std::size_t>(frame.shape[b])];
        const Vector2d from = camera.to_picture(frame.position[b]);
        const Vector2d to = camera.to_picture(frame.position[b] + length * (frame.orientation[b] * Vector3d::UnitX()));
        if (from.allFinite() && to.allFinite()) {
            drawing.shapes.emplace_back(Polygon{{from, to}, false, {.ink = theme.outline, .line = line}});
        }
    }
    drawing.shapes.emplace_back(GroupEnd{});
}

/// The wall's lines as chains, each as long as one line begins where the one before ends. Ends of pieces that meet do
/// so up to rounding (m).
static std::vector<Polygon> chains_of(const observe::FrameWall& wall) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& vertex : wall.vertices) {
        box.extend(vertex);
    }
    const double same = 1e-9 * box.diagonal().norm();
    std::vector<Polygon> chains;
    for (const std::array<int, 2>& line : wall.lines) {
        const Vector2d from = wall.vertices[static_cast<std::size_t>(line[0])].head<2>();
        const Vector2d to = wall.vertices[static_cast<std::size_t>(line[1])].head<2>();
        if (chains.empty() || (chains.back().points.back() - from).norm() > same) {
            chains.push_back({{from}, false, {}});
        }
        chains.back().points.push_back(to);
    }
    for (Polygon& chain : chains) {
        if (chain.points.size() > 2 && (chain.points.front() - chain.points.back()).norm() <= same) {
            chain.points.pop_back();
            chain.closed = true;
        }
    }
    return chains;
}

void Drafter::add_walls(const observe::Frame& frame, Drawing& drawing) const {
    const Theme& theme = page_.style.theme;
    const Look look{.ink = edge_share * theme.edge + (1 - edge_share) * theme.background,
                    .line = page_.wall_line(),
                    .long_ends = true};
    drawing.shapes.emplace_back(GroupBegin{.name = "walls"});
    for (std::size_t w = 0; w < page_.layout->walls.size() && w < frame.walls.size(); ++w) {
        for (Polygon& chain : chains_of(page_.layout->walls[w])) {
            for (Vector2d& point : chain.points) {
                const Vector3d world =
                    frame.walls[w].rotation * Vector3d(point.x(), point.y(), 0) + frame.walls[w].translation;
                point = page_.camera.to_picture(world);
            }
            chain.look = look;
            drawing.shapes.emplace_back(std::move(chain));
        }
    }
    drawing.shapes.emplace_back(GroupEnd{});
}

/// Halo and ink of one stroke.
static void add_stroke(const Stroke& stroke, Drawing& drawing) {
    const double halo = halo_of(stroke);
    const auto add_lines = [&](double thickness, const Vector3d& color) {
        for (std::size_t k = 0; k + 1 < stroke.points.size();) {
            Polygon line{{stroke.points[k], stroke.points[k + 1]}, false, {.ink = color, .line = thickness}};
            for (k += 2; k + 1 < stroke.points.size() && stroke.points[k] == line.points.back(); k += 2) {
                line.points.push_back(stroke.points[k + 1]);
            }
            drawing.shapes.emplace_back(std::move(line));
        }
    };
    switch (stroke.kind) {
    case Stroke::Kind::line:
    case Stroke::Kind::way:
        add_lines(stroke.thickness + 2 * halo, stroke.ink.halo);
        add_lines(stroke.thickness, stroke.ink.color);
        return;
    case Stroke::Kind::arrow: {
        const ArrowShape arrow = arrow_shape(stroke);
        if (!arrow.outline.empty()) {
            drawing.shapes.emplace_back(Polygon{
                arrow.outline, true, {.fill = stroke.ink.halo, .ink = stroke.ink.halo, .line = 2 * arrow.halo}});
            drawing.shapes.emplace_back(Polygon{arrow.outline, true, {.fill = stroke.ink.color}});
        }
        return;
    }
    case Stroke::Kind::dot:
        drawing.shapes.emplace_back(Circle{
            stroke.points[0], stroke.thickness, {.fill = stroke.ink.halo, .ink = stroke.ink.halo, .line = 2 * halo}});
        drawing.shapes.emplace_back(Circle{stroke.points[0], stroke.thickness, {.fill = stroke.ink.color}});
        return;
    }
}

void Drafter::add_marks(const observe::Frame& frame, Drawing& drawing) const {
    if (!page_.mark_maker.any()) {
        return;
    }
    drawing.shapes.emplace_back(GroupBegin{.name = "marks"});
    for (const Stroke& stroke : page_.mark_maker.strokes(frame, page_.mark_view())) {
        add_stroke(stroke, drawing);
    }
    drawing.shapes.emplace_back(GroupEnd{});
}

} // namespace tumble::render
