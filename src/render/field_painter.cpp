#include "render/field_painter.h"

#include "render/color_range.h"
#include "render/crevice_shade.h"
#include "render/draw_crew.h"
#include "render/field_drawer.h"
#include "render/gl_context.h"
#include "render/overlay.h"
#include "render/sphere_drawer.h"
#include "render/wall_drawer.h"

#include <algorithm>
#include <cmath>

namespace tumble::render {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

namespace {

constexpr int samples_a_pixel = 4;
constexpr double body_share = 0.3; // of the letters' colour in the bodies', the rest is the background's

std::optional<Problem> refuse(const Field& field) {
    const auto count = static_cast<int>(field.points.size());
    const auto inside = [&](int point) { return point >= 0 && point < count; };
    bool whole = count > 0 && field.values.size() == field.points.size();
    for (const auto& triangle : field.triangles)
        whole = whole && std::all_of(triangle.begin(), triangle.end(), inside);
    for (const auto& line : field.lines)
        whole = whole && std::all_of(line.begin(), line.end(), inside);
    if (!whole)
        return Problem{.what = "a field without points, values or corners of its triangles",
                       .fix = "give a value a point, and indices into the points"};
    for (std::size_t p = 0; p < field.points.size(); ++p)
        if (!field.points[p].allFinite() || !std::isfinite(field.values[p]))
            return Problem{.what = "a field has a point or value that is not finite", .fix = "leave it out"};
    return std::nullopt;
}

/// The frame's layout without the part that the field stands for.
std::shared_ptr<const observe::FrameLayout> without(const observe::FrameLayout& layout, int part) {
    auto rest = std::make_shared<observe::FrameLayout>(layout);
    if (part >= 0 && part < static_cast<int>(rest->walls.size())) {
        observe::FrameWall& wall = rest->walls[static_cast<std::size_t>(part)];
        wall.vertices.clear();
        wall.triangles.clear();
    }
    return rest;
}

/// `veil` of the first over the rest of the second.
void lay_over(const Picture& veiled, double veil, Picture& bare) {
    for (std::size_t i = 0; i < bare.rgba.size(); ++i)
        bare.rgba[i] = static_cast<std::uint8_t>(std::lround(veil * veiled.rgba[i] + (1 - veil) * bare.rgba[i]));
}

/// All that holds a name in the GL context.
struct FieldCanvas {
    static Result<FieldCanvas> open(const scene::Render& settings, const Theme& theme, const ColorMap& map,
                                    std::shared_ptr<const observe::FrameLayout> scenery, const Layout& layout) {
        auto canvas = make_canvas(settings.width, settings.height, samples_a_pixel);
        if (!canvas)
            return canvas.problems();
        auto spheres = SphereDrawer::open(*canvas);
        auto walls = WallDrawer::open(*scenery, theme, *canvas);
        auto field = FieldDrawer::open(map, theme);
        auto crevices = CreviceShade::open(*canvas);
        auto overlay = Overlay::open(layout, theme);
        auto crew = gather_draw_crew();
        for (const Problems& found : {spheres.problems(), walls.problems(), field.problems(), crevices.problems(),
                                      overlay.problems(), crew.problems()})
            if (!found.empty())
                return found;
        return FieldCanvas{theme,
                           layout,
                           std::move(scenery),
                           std::move(*canvas),
                           std::move(*spheres),
                           std::move(*walls),
                           std::move(*field),
                           std::move(*crevices),
                           std::move(*overlay),
                           std::move(*crew)};
    }

    /// Bodies that would hide the field are before it, or with `bare` behind it.
    Picture draw(const Field& field, const Span& span, bool lit, const Camera& camera, const observe::Frame* around,
                 bool bare) {
        glViewport(0, 0, canvas.width, canvas.height);
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
        const Eigen::Vector3f back = theme.background.cast<float>();
        glClearColor(back.x(), back.y(), back.z(), 1);
        glClearDepth(1);
        glDepthMask(GL_TRUE);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        keep_to_window(canvas, layout.window);
        if (around)
            draw_bodies(*around, camera);
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
        glDepthMask(GL_TRUE);
        if (bare)
            glClear(GL_DEPTH_BUFFER_BIT);
        fields.draw(field, span, camera, canvas, lit);
        glDisable(GL_SCISSOR_TEST);
        resolve_samples(canvas, GL_COLOR_BUFFER_BIT);
        return read_picture(canvas);
    }

    /// The finished picture with its letters; returns where the colour bar lies.
    Area letter(Picture& picture, const OverlayContent& content) {
        glBindTexture(GL_TEXTURE_2D, canvas.color.name());
        Picture turned = picture; // GL counts rows from below
        const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
        for (int y = 0; y < picture.height; ++y)
            std::copy_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y, row,
                        turned.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (picture.height - 1 - y));
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        turned.rgba.data());
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.resolved.name());
        const Area bar = overlay.draw(content, layout, picture.width, picture.height);
        picture = read_picture(canvas);
        return bar;
    }

    Theme theme;
    Layout layout;
    std::shared_ptr<const observe::FrameLayout> scenery;
    Canvas canvas;
    SphereDrawer spheres;
    WallDrawer walls;
    FieldDrawer fields;
    CreviceShade crevices;
    Overlay overlay;
    std::unique_ptr<Crew> crew;
    SphereRaster raster{};

    void draw_bodies(const observe::Frame& frame, const Camera& camera) {
        const Vector3d grey = body_share * theme.text + (1 - body_share) * theme.background;
        std::uint32_t bytes = 0xff000000U;
        for (int k = 0; k < 3; ++k)
            bytes |= static_cast<std::uint32_t>(std::lround(255 * grey[k])) << (8 * k);
        const std::vector<std::uint32_t> colors(frame.bodies(), bytes);
        const auto marks = collect_spheres(frame, showing_spheres(*scenery), colors, camera);
        spheres.draw(marks, camera, canvas, {layout.window, theme.rim, true, true}, raster, *crew);
        walls.draw_opaque(frame, camera, canvas);
        double size = 0;
        for (const observe::FrameShape& shape : scenery->shapes)
            for (std::size_t s = 0; s < shape.centres.size(); ++s)
                size = std::max(size, shape.centres[s].norm() + shape.radii[s]);
        glDisable(GL_SCISSOR_TEST); // shade needs its surroundings
        resolve_samples(canvas, GL_DEPTH_BUFFER_BIT);
        if (size > 0)
            crevices.draw(canvas, camera, crevice_radius * size, crevice_strength, *crew);
        keep_to_window(canvas, layout.window);
        walls.draw_translucent(frame, camera, canvas, std::max(1.2, 1.5 * layout.unit));
    }
};

OverlayContent content_of(const Field& field, const FieldLook& look, const FieldPicture& painted, const ColorMap& map) {
    const Camera& camera = painted.camera;
    const Span& span = painted.span;
    OverlayContent content;
    content.title = look.title;
    content.time = look.note;
    if (!look.caption.empty()) {
        Area under = painted.layout.scene; // in the margin that the camera leaves
        under.top = under.bottom - camera_margin * under.height() + 2 * painted.layout.unit;
        content.captions = {{under, look.caption}};
    }
    content.legend = {.label = field.label, .unit = field.unit, .span = span, .map = map, .note = look.key};
    for (const double value : field.values) {
        content.legend.below = content.legend.below || value < span.lo;
        content.legend.above = content.legend.above || value > span.hi;
    }
    content.pixels_per_metre = camera.pixels_per_metre(camera.target);
    content.scale_note = camera.perspective ? " at the centre" : "";
    for (int i = 0; i < 3; ++i)
        content.axes[static_cast<std::size_t>(i)] =
            look.axes ? Eigen::Vector2d(camera.axes(0, i), -camera.axes(1, i)) : Eigen::Vector2d::Zero();
    return content;
}

} // namespace

Result<FieldPicture> paint_field(const scene::Render& settings, const Field& field, const FieldLook& look,
                                 const observe::Frame* around) {
    if (const auto problem = refuse(field))
        return *problem;
    const auto theme = find_theme(settings.background);
    const auto map = find_color_map(settings.colormap, field.has_sign);
    AlignedBox3d bounds;
    for (const Vector3d& point : field.points)
        bounds.extend(point);
    const AlignedBox3d box = settings.view ? AlignedBox3d(settings.view->lo, settings.view->hi) : bounds;
    const auto tried = make_camera(settings, box, {0, 0, 100, 100});
    for (const Problems& found : {theme.problems(), map.problems(), tried.problems()})
        if (!found.empty())
            return found;
    const auto look_into = [&](const Area& area) { return *make_camera(settings, box, area); };
    FieldPicture painted;
    painted.layout = make_layout(settings.width, settings.height, false, [&](const Area& area) {
        const Camera fitted = look_into(area);
        return fitted.pixels_per_metre(fitted.target);
    });
    painted.camera = look_into(painted.layout.scene);
    Camera& camera = painted.camera;
    camera.enclose(around ? bounds.merged(bounds_of(*around)) : bounds);
    ColorRange range(look.span, field.has_sign);
    painted.span = range.next(field.values);

    const auto context = GlContext::open();
    if (!context)
        return context.problems();
    const GlContext::Current current(*context);
    const auto scenery = around ? without(*around->layout, look.part) : std::make_shared<observe::FrameLayout>();
    auto canvas = FieldCanvas::open(settings, *theme, *map, scenery, painted.layout);
    if (!canvas)
        return canvas.problems();
    painted.picture = canvas->draw(field, painted.span, look.lit, camera, around, true);
    if (around && look.veil > 0)
        lay_over(canvas->draw(field, painted.span, look.lit, camera, around, false), look.veil, painted.picture);
    if (painted.layout.lettered)
        painted.legend_bar = canvas->letter(painted.picture, content_of(field, look, painted, *map));
    return painted;
}

} // namespace tumble::render
