#include "render/painter.h"

#include "render/draw_crew.h"
#include "render/drawers.h"
#include "render/gl_context.h"
#include "render/mark_key.h"
#include "render/overlay.h"
#include "render/paper.h"
#include "render/phase_clock.h"
#include "render/style.h"

#include <algorithm>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <utility>

namespace tumble::render {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr int fine_samples = 4;   // a pixel
constexpr int sketch_samples = 0; // one, as OpenGL says it: Mesa makes four of 1
// Outlines of discs, pixels at a picture's usual size; on small discs no more than this share of the smallest radius.
constexpr double disc_line = 1.2;
constexpr double disc_line_share = 0.25;

struct Painter::Inside {
    GlContext context;
    scene::Render settings;
    PainterOptions options;
    std::shared_ptr<const observe::FrameLayout> layout;
    Style style;
    MarkMaker mark_maker;
    std::vector<std::vector<int>> showing;
    std::vector<double> reach;     // per shape, m: radius about the centre of mass that holds it
    std::vector<double> spokes;    // per shape, m, in two dimensions
    std::map<int, Drawers> opened; // by samples a pixel
    Drawers* drawers = nullptr;    // those at work
    bool sketching = false;
    std::optional<Overlay> overlay; // its letters depend on the arrangement
    SphereRaster raster;
    std::unique_ptr<Crew> crew; // that draws beside the graphics library
    PhaseClock clock;

    AlignedBox3d fitted;
    bool arranged = false;
    Layout arrangement;
    Camera camera;
    Area legend_bar;
    Span span;

    Inside(GlContext made, const scene::Render& wanted, const PainterOptions& chosen,
           std::shared_ptr<const observe::FrameLayout> scenery, Style shown, std::unique_ptr<Crew> threads)
        : context(std::move(made)), settings(wanted), options(chosen), layout(std::move(scenery)),
          style(std::move(shown)), mark_maker(wanted.marks), crew(std::move(threads)) {}
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        const GlContext::Current current(context);
        overlay.reset();
        opened.clear();
    }

    /// What must be in the picture.
    [[nodiscard]] AlignedBox3d box() const {
        return settings.view ? AlignedBox3d(settings.view->lo, settings.view->hi) : fitted;
    }
    /// Opens them where there are none yet of so many samples; false with problems.
    bool take_drawers(int samples, Problems& problems);
    void arrange();
    void enclose(const observe::Frame& frame);
    std::vector<std::uint32_t> colors_of(const observe::Frame& frame, Legend& legend);
    std::vector<std::uint32_t> take_in(const observe::Frame& frame, Legend& legend);
    void draw_bodies(const observe::Frame& frame, const std::vector<std::uint32_t>& colors);
    void draw_spheres(const observe::Frame& frame, const std::vector<std::uint32_t>& colors);
    void draw_discs(const observe::Frame& frame, const std::vector<std::uint32_t>& colors);
    void shade_crevices();
    [[nodiscard]] MarkView mark_view() const;
    void draw_marks(const observe::Frame& frame);
    void write(const observe::Frame& frame, const PlotLine& plot, const Legend& legend);
};

Result<Painter> Painter::open(const scene::Render& settings, std::shared_ptr<const observe::FrameLayout> layout,
                              const PainterOptions& options) {
    auto style = find_style(settings, layout->dimension);
    if (!style) {
        return style.problems();
    }
    Problems problems;
    auto context = GlContext::open();
    auto crew = gather_draw_crew();
    if (!context || !crew) {
        return context ? crew.problems() : context.problems();
    }
    auto inside =
        std::make_unique<Inside>(*context, settings, options, std::move(layout), std::move(*style), std::move(*crew));
    const GlContext::Current current(inside->context);
    // Opened again once the arrangement is known; here it shows whether it can be.
    const auto overlay = Overlay::open(Layout{}, inside->style.theme);
    problems = overlay.problems();
    if (!problems.empty() || !inside->take_drawers(fine_samples, problems)) {
        return problems;
    }
    inside->showing = showing_spheres(*inside->layout);
    for (const observe::FrameShape& shape : inside->layout->shapes) {
        double& reach = inside->reach.emplace_back(0);
        for (std::size_t s = 0; s < shape.centres.size(); ++s) {
            reach = std::max(reach, shape.centres[s].norm() + shape.radii[s]);
        }
        inside->spokes.push_back(inside->layout->dimension == 2 ? spoke_length(shape) : 0);
    }
    return Painter(std::move(inside));
}

bool Painter::Inside::take_drawers(int samples, Problems& problems) {
    auto found = opened.find(samples);
    if (found == opened.end()) {
        auto made = Drawers::open(settings, *layout, style.theme, samples);
        if (!made) {
            problems = made.problems();
            return false;
        }
        found = opened.emplace(samples, std::move(*made)).first;
    }
    drawers = &found->second;
    return true;
}

Result<Done> Painter::resize(int width, int height) {
    Inside& in = *inside_;
    scene::Render wanted = in.settings;
    wanted.width = width;
    wanted.height = height;
    const auto style = find_style(wanted, in.layout->dimension);
    if (!style) {
        return style.problems();
    }
    const GlContext::Current current(in.context);
    const int samples = in.sketching ? sketch_samples : fine_samples;
    auto made = Drawers::open(wanted, *in.layout, in.style.theme, samples);
    if (!made) {
        return made.problems();
    }
    in.settings = std::move(wanted);
    in.opened.clear();
    in.drawers = &in.opened.emplace(samples, std::move(*made)).first->second;
    in.arranged = false;
    return Done{};
}

Result<Done> Painter::set_sketching(bool on) {
    const GlContext::Current current(inside_->context);
    Problems problems;
    if (!inside_->take_drawers(on ? sketch_samples : fine_samples, problems)) {
        return problems;
    }
    inside_->sketching = on;
    return Done{};
}

Painter::Painter(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Painter::Painter(Painter&&) noexcept = default;
Painter& Painter::operator=(Painter&&) noexcept = default;
Painter::~Painter() = default;

Result<Done> Painter::restyle(const scene::Render& settings) {
    Inside& in = *inside_;
    scene::Render wanted = settings;
    wanted.width = in.settings.width;
    wanted.height = in.settings.height;
    wanted.background = in.settings.background;
    wanted.paper = in.settings.paper;
    wanted.plot = in.settings.plot;
    auto style = find_style(wanted, in.layout->dimension);
    if (!style) {
        return style.problems();
    }
    if (wanted.color != in.settings.color || wanted.range != in.settings.range) {
        in.style.range = style->range; // else what an automatic range has seen goes on to count
    }
    const bool was_plain = in.style.plain();
    in.style.quantity = style->quantity;
    in.style.map = style->map;
    in.settings = std::move(wanted);
    const int rows = in.mark_maker.key(*in.layout, in.mark_view()).rows();
    in.mark_maker.restyle(in.settings.marks);
    if (in.mark_maker.key(*in.layout, in.mark_view()).rows() != rows || in.style.plain() != was_plain) {
        in.arranged = false; // their key takes or leaves room
    } else if (in.arranged) {
        in.camera = *make_camera(in.settings, in.box(), in.arrangement.scene);
    }
    return Done{};
}

void Painter::fit(const AlignedBox3d& box) {
    inside_->fitted.extend(box);
    inside_->arranged = false;
}

/// Settles panels and camera for what has been fitted.
void Painter::Inside::arrange() {
    const auto look = [&](const Area& area) { return *make_camera(settings, box(), area); };
    const auto zoom = [&](const Area& area) {
        const Camera tried = look(area);
        return tried.pixels_per_metre(tried.target);
    };
    arrangement = make_layout(settings.width, settings.height, settings.plot, zoom,
                              settings.paper ? std::optional(letter_unit(*settings.paper)) : std::nullopt);
    if (settings.paper) {
        leave_out_title(arrangement);
    }
    take_key(arrangement, mark_maker.key(*layout, mark_view()).rows(), !style.plain());
    if (!options.lettering) {
        arrangement = Layout{};
        arrangement.lettered = false;
        arrangement.unit = options.unit;
        arrangement.scene = {0, 0, static_cast<double>(settings.width), static_cast<double>(settings.height)};
        arrangement.window = arrangement.scene;
    }
    camera = look(arrangement.scene);
    overlay.reset();
    if (arrangement.lettered) {
        auto letters = Overlay::open(arrangement, style.theme);
        if (!letters) {
            throw std::bad_alloc(); // the one reason left: open() has shown that it can be done
        }
        overlay = std::move(*letters);
    }
    arranged = true;
}

/// Nearest and farthest about all bodies and walls of this frame, wherever they have gone.
void Painter::Inside::enclose(const observe::Frame& frame) {
    AlignedBox3d box;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        if (frame.position[b].allFinite()) {
            const double r = reach[static_cast<std::size_t>(frame.shape[b])];
            box.extend(AlignedBox3d(frame.position[b].array() - r, frame.position[b].array() + r));
        }
    }
    for (std::size_t w = 0; w < layout->walls.size() && w < frame.walls.size(); ++w) {
        for (const Vector3d& vertex : layout->walls[w].vertices) {
            box.extend(frame.walls[w].rotation * vertex + frame.walls[w].translation);
        }
    }
    if (!box.isEmpty()) {
        camera.enclose(box);
    }
}

std::vector<std::uint32_t> Painter::Inside::colors_of(const observe::Frame& frame, Legend& legend) {
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

void Painter::Inside::draw_bodies(const observe::Frame& frame, const std::vector<std::uint32_t>& colors) {
    if (layout->dimension == 2) {
        draw_discs(frame, colors);
    } else {
        draw_spheres(frame, colors);
    }
}

void Painter::Inside::draw_spheres(const observe::Frame& frame, const std::vector<std::uint32_t>& colors) {
    std::optional<AlignedBox3d> clip;
    if (settings.clip) {
        clip.emplace(settings.clip->lo, settings.clip->hi);
    }
    SphereLook look{arrangement.window, style.theme.rim, options.lighting, options.skip_hidden};
    if (settings.clip_cuts) {
        look.cut = clip;
    }
    drawers->spheres.draw(collect_spheres(frame, showing, colors, camera, clip, settings.clip_cuts), camera,
                          drawers->canvas, look, raster, *crew);
}

void Painter::Inside::draw_discs(const observe::Frame& frame, const std::vector<std::uint32_t>& colors) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const observe::FrameShape& shape : layout->shapes) {
        for (const double radius : shape.radii) {
            smallest = std::min(smallest, radius);
        }
    }
    const double pixels = smallest * camera.pixels_per_metre(camera.target);
    // Bodies without a colour step back behind what is drawn over them.
    const bool plain = style.plain();
    const DiscLook look{plain ? style.theme.plain_edge : style.theme.outline,
                        std::min(disc_line * std::max(1.0, arrangement.unit), disc_line_share * pixels)};
    const auto turns = plain ? std::vector<SpokeMark>{} : collect_spokes(frame, spokes, camera);
    glBindFramebuffer(GL_FRAMEBUFFER, drawers->canvas.samples.name());
    drawers->discs.draw(collect_discs(frame, colors, camera), turns, camera, drawers->canvas.width,
                        drawers->canvas.height, look);
}

void Painter::Inside::shade_crevices() {
    if (!options.lighting || sketching || reach.empty() || layout->dimension == 2) {
        return;
    }
    resolve_samples(drawers->canvas, GL_DEPTH_BUFFER_BIT);
    const double size = *std::max_element(reach.begin(), reach.end());
    drawers->crevices.draw(drawers->canvas, camera, crevice_radius * size, crevice_strength, *crew);
}

void Painter::Inside::write(const observe::Frame& frame, const PlotLine& plot, const Legend& legend) {
    OverlayContent content;
    content.title = settings.paper ? "" : layout->title;
    content.time = time_stamp(frame.time, settings.every);
    content.legend = legend;
    content.key = mark_maker.key(*layout, mark_view());
    content.plot = settings.plot && !plot.label.empty() ? &plot : nullptr;
    content.now = frame.time;
    content.pixels_per_metre = camera.pixels_per_metre(camera.target);
    content.scale_note = camera.perspective ? " at the centre" : "";
    for (int i = 0; i < 3; ++i) {
        const Vector3d axis = camera.axes.col(i);
        content.axes[static_cast<std::size_t>(i)] = {axis.x(), -axis.y()};
    }
    legend_bar = overlay->draw(content, arrangement, settings.width, settings.height);
}

/// What a frame changes for those after it: the depth that the camera sees, the range of the colours.
std::vector<std::uint32_t> Painter::Inside::take_in(const observe::Frame& frame, Legend& legend) {
    if (!arranged) {
        arrange();
    }
    enclose(frame);
    mark_maker.take_in(frame, mark_view());
    return colors_of(frame, legend);
}

MarkView Painter::Inside::mark_view() const {
    MarkView view{camera, arrangement.window, arrangement.unit, style.theme, {}};
    if (settings.clip && layout->dimension == 3) {
        view.clip.emplace(settings.clip->lo, settings.clip->hi);
    }
    return view;
}

void Painter::Inside::draw_marks(const observe::Frame& frame) {
    if (!mark_maker.any()) {
        return;
    }
    const Canvas& canvas = drawers->canvas;
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    drawers->patches.draw(mark_maker.patches(frame, mark_view()), canvas.width, canvas.height);
}

void Painter::foresee(const observe::Frame& frame) {
    const GlContext::Current current(inside_->context);
    if (inside_->fitted.isEmpty()) {
        fit(bounds_of(frame));
    }
    if (!inside_->arranged) {
        inside_->arrange();
    }
    inside_->mark_maker.foresee(frame, inside_->mark_view());
}

void Painter::pass_over(const observe::Frame& frame) {
    const GlContext::Current current(inside_->context);
    if (inside_->fitted.isEmpty()) {
        fit(bounds_of(frame));
    }
    Legend legend;
    (void)inside_->take_in(frame, legend);
}

Picture Painter::draw(const observe::Frame& frame, const PlotLine& plot) {
    Inside& in = *inside_;
    const GlContext::Current current(in.context);
    in.clock.start(in.options.time_phases);
    if (in.fitted.isEmpty()) {
        fit(bounds_of(frame));
    }
    Legend legend;
    const std::vector<std::uint32_t> colors = in.take_in(frame, legend);

    const Canvas& canvas = in.drawers->canvas;
    glViewport(0, 0, canvas.width, canvas.height);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    const Eigen::Vector3f back = in.style.theme.background.cast<float>();
    glClearColor(back.x(), back.y(), back.z(), 1);
    glClearDepth(1);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    in.clock.lap("take in");
    keep_to_window(canvas, in.arrangement.window);
    in.draw_bodies(frame, colors);
    in.clock.lap("bodies");
    in.drawers->walls.draw_opaque(frame, in.camera, canvas);
    glDisable(GL_SCISSOR_TEST); // shade needs its surroundings, and there is none where nothing has been drawn
    in.shade_crevices();
    in.clock.lap("crevices");
    const double thickness = in.layout->dimension == 2 ? 2.0 : 1.0; // walls are nothing but their lines
    const double line = thickness * std::max(1.2, 1.5 * in.arrangement.unit);
    keep_to_window(canvas, in.arrangement.window);
    in.drawers->walls.draw_translucent(frame, in.camera, canvas, line);
    in.draw_marks(frame);
    glDisable(GL_SCISSOR_TEST);
    in.clock.lap("walls");
    resolve_samples(canvas, GL_COLOR_BUFFER_BIT);
    if (in.overlay) {
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.resolved.name());
        in.write(frame, plot, legend);
    }
    in.clock.lap("letters");
    Picture picture = read_picture(canvas);
    picture.dots_per_metre = dots_per_metre(in.settings);
    in.clock.lap("read back");
    return picture;
}

const Camera& Painter::camera() const {
    return inside_->camera;
}
const Layout& Painter::layout() const {
    return inside_->arrangement;
}
const Area& Painter::legend_bar() const {
    return inside_->legend_bar;
}
const Span& Painter::range() const {
    return inside_->span;
}
MarkKey Painter::mark_key() const {
    return inside_->mark_maker.key(*inside_->layout, inside_->mark_view());
}
const std::vector<PhaseTime>& Painter::phase_times() const {
    return inside_->clock.times();
}

} // namespace tumble::render
