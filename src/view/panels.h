#pragma once

#include "render/marks.h"
#include "render/panel_canvas.h"
#include "render/theme.h"
#include "scene/scene.h"
#include "view/controls.h"
#include "view/plots.h"
#include "view/source.h"

#include <array>
#include <map>
#include <string>

namespace tumble::view {

/// What a press in the panel asks for beyond what it changes itself.
struct Wishes {
    bool restyle = false; // the look was changed
    bool fit_range = false;
    bool picture = false; // PNG
    bool film = false;
    bool film_ends = false;
    bool save_scene = false;
    std::string camera; // "front", "side", "top", "fit"; empty: as it is
};

/// All that the panel shows and changes.
struct Desk {
    Source& source;
    Controls& controls;
    const Plots& plots;
    scene::Render& look;
    const observe::FrameLayout& layout;
    std::array<double, 2> range{}; // that the colours have now
    render::MarkKey key{};         // what the lines over the bodies mean now
    std::string notice;            // what was kept last
    std::string saved;             // the scene's file, or why there is none
    bool saved_anew = false;       // and nobody has seen it yet
    std::string warnings;          // of what is missing of a run
    SourceState state;
    double now = 0; // s

    Wishes wishes;
    std::map<std::string, std::array<double, 4>> places; // left, top, right, bottom of what can be touched, by name
    std::string told_key;                                // of the scene, that the widget under the pointer sets
};

/// The widgets, between ImGui::NewFrame and ImGui::Render, over the whole canvas.
void lay_out_panel(Desk& desk, const render::PanelCanvas& canvas, const render::Theme& theme);

} // namespace tumble::view
