#include "render/panel_canvas.h"

#include "render/gl_context.h"
#include "render/gl_objects.h"
#include "render/imgui_session.h"
#include "render/panel_drawer.h"

#include <imgui.h>
#include <optional>
#include <utility>

namespace tumble::render {

struct PanelCanvas::Inside {
    GlContext context;
    ImGuiSession session;
    double unit;
    std::optional<Canvas> canvas;
    std::optional<PanelDrawer> drawer;

    Inside(GlContext made, double scale) : context(std::move(made)), session(scale), unit(scale) {}
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        const GlContext::Current current(context);
        drawer.reset();
        canvas.reset();
    }
};

PanelCanvas::PanelCanvas(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
PanelCanvas::PanelCanvas(PanelCanvas&&) noexcept = default;
PanelCanvas& PanelCanvas::operator=(PanelCanvas&&) noexcept = default;
PanelCanvas::~PanelCanvas() = default;

Result<PanelCanvas> PanelCanvas::open(int width, int height, double unit) {
    auto context = GlContext::open();
    if (!context) {
        return context.problems();
    }
    auto inside = std::make_unique<Inside>(*context, unit);
    PanelCanvas panel(std::move(inside));
    if (auto sized = panel.resize(width, height); !sized) {
        return sized.problems();
    }
    const GlContext::Current current(panel.inside_->context);
    const ImGuiSession::Current session(panel.inside_->session);
    auto drawer = PanelDrawer::open(*ImGui::GetIO().Fonts);
    if (!drawer) {
        return drawer.problems();
    }
    panel.inside_->drawer = std::move(*drawer);
    return panel;
}

Result<Done> PanelCanvas::resize(int width, int height) {
    const GlContext::Current current(inside_->context);
    auto canvas = make_canvas(width, height, 1);
    if (!canvas) {
        return canvas.problems();
    }
    inside_->canvas = std::move(*canvas);
    return Done{};
}

Result<Done> PanelCanvas::rescale(double unit) {
    if (unit == inside_->unit) {
        return Done{};
    }
    inside_->session.rescale(unit);
    inside_->unit = unit;
    const GlContext::Current current(inside_->context);
    const ImGuiSession::Current session(inside_->session);
    auto drawer = PanelDrawer::open(*ImGui::GetIO().Fonts);
    if (!drawer) {
        return drawer.problems();
    }
    inside_->drawer = std::move(*drawer);
    return Done{};
}

void PanelCanvas::pass(const Step& feed, const Step& build) {
    const ImGuiSession::Current session(inside_->session);
    ImGui::GetIO().DisplaySize = {static_cast<float>(inside_->canvas->width),
                                  static_cast<float>(inside_->canvas->height)};
    feed();
    ImGui::NewFrame();
    build();
    ImGui::Render();
}

Picture PanelCanvas::paint() {
    const GlContext::Current current(inside_->context);
    const ImGuiSession::Current session(inside_->session);
    const Canvas& canvas = *inside_->canvas;
    glViewport(0, 0, canvas.width, canvas.height);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.resolved.name());
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (const ImDrawData* data = ImGui::GetDrawData()) {
        inside_->drawer->draw(*data, canvas.width, canvas.height);
    }
    return read_picture(canvas);
}

const ScreenPen::Fonts& PanelCanvas::fonts() const {
    return inside_->session.fonts();
}
double PanelCanvas::unit() const {
    return inside_->unit;
}

} // namespace tumble::render
