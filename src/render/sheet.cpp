#include "render/sheet.h"

#include "render/drawing_pen.h"
#include "render/gl_context.h"
#include "render/gl_objects.h"
#include "render/paper.h"

#include <optional>
#include <utility>

namespace tumble::render {

struct PictureSheet::Inside {
    GlContext context;
    Layout lettering;
    Theme theme;
    double dots = 0; // a metre
    std::optional<Canvas> canvas;
    std::optional<Overlay> overlay;

    Inside(GlContext made, const Layout& arrangement, Theme colors, double dots_a_metre)
        : context(std::move(made)), lettering(arrangement), theme(std::move(colors)), dots(dots_a_metre) {}
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        const GlContext::Current current(context);
        overlay.reset();
        canvas.reset();
    }
};

Result<PictureSheet> PictureSheet::open(const scene::Render& settings, int height, const Layout& lettering,
                                        const Theme& theme) {
    auto context = GlContext::open();
    if (!context) {
        return context.problems();
    }
    auto inside = std::make_shared<Inside>(*context, lettering, theme, dots_per_metre(settings));
    const GlContext::Current current(inside->context);
    auto canvas = make_canvas(settings.width, height, 1);
    auto overlay = Overlay::open(lettering, theme);
    if (!canvas || !overlay) {
        return canvas ? overlay.problems() : canvas.problems();
    }
    inside->canvas = std::move(*canvas);
    inside->overlay = std::move(*overlay);
    return PictureSheet(std::move(inside));
}

Picture PictureSheet::put_together(std::span<const Picture> parts, std::span<const Area> areas,
                                   const OverlayContent& content) {
    Inside& in = *inside_;
    const GlContext::Current current(in.context);
    glViewport(0, 0, in.canvas->width, in.canvas->height);
    glBindFramebuffer(GL_FRAMEBUFFER, in.canvas->resolved.name());
    const Eigen::Vector3f back = in.theme.background.cast<float>();
    glClearColor(back.x(), back.y(), back.z(), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    in.overlay->draw(content, in.lettering, in.canvas->width, in.canvas->height);
    Picture picture = read_picture(*in.canvas);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        paste(parts[k], static_cast<int>(areas[k].left), static_cast<int>(areas[k].top), picture);
    }
    picture.dots_per_metre = in.dots;
    picture.crowded = in.overlay->crowded();
    picture.bare = bare_of(parts);
    return picture;
}

Result<DrawingSheet> DrawingSheet::open(const scene::Render& settings, int height, const Layout& lettering,
                                        const Theme& theme) {
    return DrawingSheet(blank_drawing(settings, height, theme), lettering, theme);
}

Drawing DrawingSheet::put_together(std::span<const Drawing> parts, std::span<const Area> areas,
                                   const OverlayContent& content) {
    Drawing drawing = blank_;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        drawing.shapes.emplace_back(GroupBegin{.name = "part", .at = {areas[k].left, areas[k].top}});
        drawing.shapes.insert(drawing.shapes.end(), parts[k].shapes.begin(), parts[k].shapes.end());
        drawing.shapes.emplace_back(GroupEnd{});
    }
    DrawingPen pen(drawing, lettering_.unit);
    write_panels(pen, content, lettering_, theme_);
    drawing.crowded = pen.crowded();
    drawing.bare = bare_of(parts);
    return drawing;
}

} // namespace tumble::render
