#include "render/painter.h"

#include "render/clip.h"
#include "render/composition.h"
#include "render/draw_crew.h"
#include "render/drawers.h"
#include "render/gl_context.h"
#include "render/overlay.h"
#include "render/paper.h"
#include "render/phase_clock.h"

#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <utility>

namespace tumble::render {

using Eigen::AlignedBox3d;

constexpr int fine_samples = 4;   // a pixel
constexpr int sketch_samples = 0; // one, as OpenGL says it: Mesa makes four of 1

struct Painter::Inside : Composition {
    GlContext context;
    std::vector<std::vector<int>> showing;
    std::map<int, Drawers> opened; // by samples a pixel
    Drawers* drawers = nullptr;    // those at work
    bool sketching = false;
    std::optional<Overlay> overlay; // its letters depend on the arrangement
    SphereRaster raster;
    std::unique_ptr<Crew> crew; // that draws beside the graphics library
    PhaseClock clock;
    Area legend_bar;

    Inside(GlContext made, const scene::Render& wanted, const PainterOptions& chosen,
           std::shared_ptr<const observe::FrameLayout> scenery, Style shown, std::unique_ptr<Crew> threads)
        : Composition(wanted, chosen, std::move(scenery), std::move(shown)), context(std::move(made)),
          crew(std::move(threads)) {}
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        const GlContext::Current current(context);
        overlay.reset();
        opened.clear();
    }

    /// Opens them where there are none yet of so many samples; false with problems.
    bool take_drawers(int samples, Problems& problems);
    void settle_with_letters(const observe::Frame& frame);
    void draw_bodies(const observe::Frame& frame, const std::vector<std::uint32_t>& colors);
    void draw_spheres(const observe::Frame& frame, const std::vector<std::uint32_t>& colors);
    void draw_discs(const observe::Frame& frame, const std::vector<std::uint32_t>& colors);
    void shade_crevices();
    void draw_marks(const observe::Frame& frame);
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
    return inside_->restyle(settings);
}

void Painter::hold_camera(const std::optional<Held>& held) {
    inside_->held = held;
}

void Painter::fit(const AlignedBox3d& box) {
    inside_->fit(box);
}

void Painter::Inside::settle_with_letters(const observe::Frame& frame) {
    if (fitted.isEmpty() || !arranged) {
        overlay.reset();
    }
    settle_for(frame);
    if (arrangement.lettered && !overlay) {
        auto letters = Overlay::open(arrangement, style.theme);
        if (!letters) {
            throw std::bad_alloc(); // the one reason left: open() has shown that it can be done
        }
        overlay = std::move(*letters);
    }
}

void Painter::Inside::draw_bodies(const observe::Frame& frame, const std::vector<std::uint32_t>& colors) {
    if (layout->dimension == 2) {
        draw_discs(frame, colors);
    } else {
        draw_spheres(frame, colors);
    }
}

void Painter::Inside::draw_spheres(const observe::Frame& frame, const std::vector<std::uint32_t>& colors) {
    const std::optional<AlignedBox3d> clip = clip_of(settings, *layout);
    SphereLook look{arrangement.window, style.theme.rim, options.lighting, options.skip_hidden};
    if (settings.clip_cuts) {
        look.cut = clip;
    }
    drawers->spheres.draw(collect_spheres(frame, showing, colors, camera, clip, settings.clip_cuts), camera,
                          drawers->canvas, look, raster, *crew);
}

void Painter::Inside::draw_discs(const observe::Frame& frame, const std::vector<std::uint32_t>& colors) {
    // Bodies without a colour step back behind what is drawn over them.
    const bool plain = style.plain();
    const DiscLook look{plain ? style.theme.plain_edge : style.theme.outline, disc_line()};
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
    inside_->settle_with_letters(frame);
    inside_->mark_maker.foresee(frame, inside_->mark_view());
}

void Painter::expect_pace(double every) {
    inside_->mark_maker.expect_pace(every);
}

void Painter::pass_over(const observe::Frame& frame) {
    const GlContext::Current current(inside_->context);
    inside_->settle_with_letters(frame);
    Legend legend;
    (void)inside_->take_in(frame, legend);
}

Picture Painter::draw(const observe::Frame& frame, const PlotLine& plot) {
    Inside& in = *inside_;
    const GlContext::Current current(in.context);
    in.clock.start(in.options.time_phases);
    in.settle_with_letters(frame);
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
    in.drawers->walls.cut_to(in.settings.clip_cuts ? clip_of(in.settings, *in.layout) : std::nullopt);
    in.drawers->walls.draw_opaque(frame, in.camera, canvas);
    glDisable(GL_SCISSOR_TEST); // shade needs its surroundings, and there is none where nothing has been drawn
    in.shade_crevices();
    in.clock.lap("crevices");
    keep_to_window(canvas, in.arrangement.window);
    in.drawers->walls.draw_translucent(frame, in.camera, canvas, in.wall_line());
    in.draw_marks(frame);
    glDisable(GL_SCISSOR_TEST);
    in.clock.lap("walls");
    resolve_samples(canvas, GL_COLOR_BUFFER_BIT);
    if (in.overlay) {
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.resolved.name());
        const OverlayContent content = in.content(frame, plot, legend);
        in.legend_bar = in.overlay->draw(content, in.arrangement, canvas.width, canvas.height);
    }
    in.clock.lap("letters");
    Picture picture = read_picture(canvas);
    picture.dots_per_metre = dots_per_metre(in.settings);
    picture.bare = in.bareness(frame);
    if (in.overlay) {
        picture.crowded = in.overlay->crowded();
    }
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
