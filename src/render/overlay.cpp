#include "render/overlay.h"

#include "render/drawing_pen.h"
#include "render/imgui_session.h"
#include "render/mark_key.h"
#include "render/panel_drawer.h"

#include <imgui.h>
#include <optional>
#include <utility>

namespace tumble::render {

struct Overlay::Inside {
    ImGuiSession session;
    Theme theme;
    std::optional<PanelDrawer> drawer;
    std::vector<Crowded> crowded{}; // of the last picture

    Inside(double unit, Theme colors) : session(unit), theme(std::move(colors)) {}
};

Result<Overlay> Overlay::open(const Layout& layout, const Theme& theme) {
    Overlay overlay;
    overlay.inside_ = std::make_shared<Inside>(layout.unit, theme);
    const ImGuiSession::Current current(overlay.inside_->session);
    auto drawer = PanelDrawer::open(*ImGui::GetIO().Fonts);
    if (!drawer) {
        return drawer.problems();
    }
    overlay.inside_->drawer = std::move(*drawer);
    return overlay;
}

void OverlayContent::look_with(const Camera& camera) {
    pixels_per_metre = camera.pixels_per_metre(camera.target);
    scale_note = camera.perspective ? " at the centre" : "";
    for (int i = 0; i < 3; ++i) {
        axes[static_cast<std::size_t>(i)] = {camera.axes(0, i), -camera.axes(1, i)};
    }
}

Area write_panels(Pen& pen, const OverlayContent& content, const Layout& layout, const Theme& theme) {
    if (!content.title.empty()) {
        // One of several headings is told from the others by its end.
        const double room = layout.title.width();
        const std::string title = content.headings.empty()
                                      ? pen.shortened(content.title, Lettering::large, room)
                                      : pen.shortened_inside(content.title, Lettering::large, room);
        pen.text(layout.title.left, layout.title.top, title, Lettering::large, Align::left, theme.text);
    }
    for (const Heading& heading : content.headings) {
        const std::string text = pen.shortened_inside(heading.text, Lettering::large, heading.area.width());
        pen.text(heading.area.left, heading.area.top, text, Lettering::large, Align::left, theme.text);
    }
    for (const Heading& caption : content.captions) {
        const std::string text = pen.entire(caption.text, Lettering::normal, caption.area.width());
        pen.text(0.5 * (caption.area.left + caption.area.right), caption.area.top, text, Lettering::normal,
                 Align::middle, theme.text);
    }
    // In a column the time stands in line with the panels below it.
    const bool in_column = layout.column;
    pen.text(in_column ? layout.time.left : layout.time.right, layout.time.top, content.time, Lettering::large,
             in_column ? Align::left : Align::right, theme.text);
    const double stamp = pen.width(content.time, Lettering::large);
    if (in_column && stamp > layout.time.width() + 12 * pen.unit())
        pen.note_crowded(content.time, layout.time.width() / stamp);
    Area bar;
    if (!content.legend.label.empty())
        bar = draw_legend(pen, layout.legend, content.legend, theme, layout.column);
    if (content.key.rows() > 0)
        draw_key(pen, layout.key, content.key, theme);
    draw_scale_bar(pen, layout.scale_bar, content.pixels_per_metre, content.scale_note, content.axes, theme);
    if (content.plot != nullptr && layout.plot.width() > 0) {
        draw_plot(pen, layout.plot, *content.plot, content.now, theme);
    }
    return bar;
}

bool is_readable(const OverlayContent& content, const Layout& layout, const Theme& theme) {
    Drawing scrap;
    DrawingPen pen(scrap, layout.unit);
    write_panels(pen, content, layout, theme);
    return pen.crowded().empty();
}

const std::vector<Crowded>& Overlay::crowded() const {
    return inside_->crowded;
}

Area Overlay::draw(const OverlayContent& content, const Layout& layout, int width, int height) {
    Inside& inside = *inside_;
    const ImGuiSession::Current current(inside.session);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = 0.04F;
    ImGui::NewFrame();
    ScreenPen pen(*ImGui::GetBackgroundDrawList(), inside.session.fonts(), layout.unit);
    const Area bar = write_panels(pen, content, layout, inside.theme);
    inside.crowded = pen.crowded();
    ImGui::Render();
    inside.drawer->draw(*ImGui::GetDrawData(), width, height);
    return bar;
}

} // namespace tumble::render
