#include "render/overlay.h"

#include "render/panel_drawer.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <imgui.h>
#include <mutex>
#include <optional>

namespace tumble::render {

// Letters of the three sizes, pixels at 1280 x 720.
constexpr double small_letters = 17;
constexpr double normal_letters = 19;
constexpr double large_letters = 23;

// Dear ImGui keeps its current context in one variable for all threads.
static std::mutex one_at_a_time;

struct Overlay::Inside {
    ImGuiContext* context = nullptr;
    Pen::Fonts fonts;
    Theme theme;
    std::optional<PanelDrawer> drawer;

    Inside() = default;
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        const std::lock_guard lock(one_at_a_time);
        ImGui::DestroyContext(context);
    }
};

/// Where distributions keep the font; empty when none of them has it.
static std::string find_font() {
    for (const char* place :
         {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
          "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"}) {
        std::error_code failed;
        if (std::filesystem::is_regular_file(place, failed)) {
            return place;
        }
    }
    return {};
}

static Pen::Fonts load_fonts(ImFontAtlas& atlas, double unit) {
    // Latin, Greek, dashes and quotes, raised digits, arrows and the minus sign.
    static constexpr std::array<ImWchar, 15> letters{0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2070, 0x208e,
                                                     0x2190, 0x2193, 0x2212, 0x2212, 0x2248, 0x2248, 0};
    const std::string file = find_font();
    const auto load = [&](double size) {
        ImFontConfig config;
        config.OversampleH = 2;
        config.OversampleV = 2;
        const auto pixels = static_cast<float>(std::max(std::round(size * unit), 6.0));
        ImFont* font = file.empty() ? nullptr : atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, letters.data());
        if (font == nullptr) {
            config.SizePixels = pixels;
            font = atlas.AddFontDefault(&config);
        }
        return font;
    };
    Pen::Fonts fonts{load(small_letters), load(normal_letters), load(large_letters), false};
    atlas.Build();
    fonts.complete = fonts.small->FindGlyphNoFallback(0x2212) != nullptr;
    return fonts;
}

Result<Overlay> Overlay::open(const Layout& layout, const Theme& theme) {
    Overlay overlay;
    overlay.inside_ = std::make_shared<Inside>();
    Inside& inside = *overlay.inside_;
    inside.theme = theme;
    const std::lock_guard lock(one_at_a_time);
    inside.context = ImGui::CreateContext();
    ImGui::SetCurrentContext(inside.context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    inside.fonts = load_fonts(*io.Fonts, layout.unit);
    auto drawer = PanelDrawer::open(*io.Fonts);
    if (!drawer) {
        return drawer.problems();
    }
    inside.drawer = std::move(*drawer);
    return overlay;
}

static Area draw_panels(Pen& pen, const OverlayContent& content, const Layout& layout, const Theme& theme) {
    if (!content.title.empty()) {
        const std::string title = pen.shortened(content.title, Lettering::large, layout.title.width());
        pen.text(layout.title.left, layout.title.top, title, Lettering::large, Align::left, theme.text);
    }
    for (const Heading& heading : content.headings) {
        const std::string text = pen.shortened(heading.text, Lettering::large, heading.area.width());
        pen.text(heading.area.left, heading.area.top, text, Lettering::large, Align::left, theme.text);
    }
    // In a column the time stands in line with the panels below it.
    const bool in_column = layout.column;
    pen.text(in_column ? layout.time.left : layout.time.right, layout.time.top, content.time, Lettering::large,
             in_column ? Align::left : Align::right, theme.text);
    const Area bar = draw_legend(pen, layout.legend, content.legend, theme, layout.column);
    draw_scale_bar(pen, layout.scale_bar, content.pixels_per_metre, content.scale_note, content.axes, theme);
    if (content.plot != nullptr && layout.plot.width() > 0) {
        draw_plot(pen, layout.plot, *content.plot, content.now, theme);
    }
    return bar;
}

Area Overlay::draw(const OverlayContent& content, const Layout& layout, int width, int height) {
    Inside& inside = *inside_;
    const std::lock_guard lock(one_at_a_time);
    ImGui::SetCurrentContext(inside.context);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = 0.04F;
    ImGui::NewFrame();
    Pen pen(*ImGui::GetBackgroundDrawList(), inside.fonts, layout.unit);
    const Area bar = draw_panels(pen, content, layout, inside.theme);
    ImGui::Render();
    inside.drawer->draw(*ImGui::GetDrawData(), width, height);
    return bar;
}

} // namespace tumble::render
