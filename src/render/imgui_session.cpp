#include "render/imgui_session.h"

#include "render/layout.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <imgui.h>
#include <string>

namespace tumble::render {

// Dear ImGui keeps its current context in one variable for all threads.
static std::mutex one_at_a_time;

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

static ScreenPen::Fonts load_fonts(ImFontAtlas& atlas, double unit) {
    // Latin, Greek, dashes and quotes, raised digits, arrows, the minus sign, about, at most and at least.
    static constexpr std::array<ImWchar, 17> letters{0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027,
                                                     0x2070, 0x208e, 0x2190, 0x2193, 0x2212, 0x2212,
                                                     0x2248, 0x2248, 0x2264, 0x2265, 0};
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
    ScreenPen::Fonts fonts{load(small_letters), load(normal_letters), load(large_letters), false};
    atlas.Build();
    fonts.complete = fonts.small->FindGlyphNoFallback(0x2212) != nullptr;
    return fonts;
}

ImGuiSession::ImGuiSession(double unit) {
    const std::lock_guard lock(one_at_a_time);
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    fonts_ = load_fonts(*io.Fonts, unit);
}

void ImGuiSession::rescale(double unit) {
    const Current current(*this);
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    fonts_ = load_fonts(atlas, unit);
}

ImGuiSession::~ImGuiSession() {
    const std::lock_guard lock(one_at_a_time);
    ImGui::DestroyContext(context_);
}

ImGuiSession::Current::Current(const ImGuiSession& session) : lock_(one_at_a_time) {
    ImGui::SetCurrentContext(session.context_);
}

} // namespace tumble::render
