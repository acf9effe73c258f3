#include "view/panels.h"

#include "base/text.h"
#include "render/panels.h"
#include "render/quantity.h"
#include "scene/keys.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace tumble::view {

namespace {

constexpr double least_plot = 172, most_plot = 260;  // units, high
constexpr double least_speed = 1e-4, most_speed = 2; // s of the scene per s of watching
constexpr double largest_scale = 1e6;                // m/s, N: what the scene's keys take

/// The widget just made, by name: where it can be touched.
void mark(Desk& desk, const std::string& name) {
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    if (ImGui::IsItemVisible())
        desk.places[name] = {lo.x, lo.y, hi.x, hi.y};
}

bool button(Desk& desk, const std::string& name, const char* label, float width = 0) {
    const bool pressed = ImGui::Button(label, {width, 0});
    mark(desk, name);
    return pressed;
}

/// The widget just made says which key of the scene it sets.
void tell_key(Desk& desk, const std::string& key) {
    if (!ImGui::IsItemHovered())
        return;
    ImGui::SetTooltip("%s", key.c_str());
    desk.told_key = key;
}

/// A slider over the panel's whole width; a number typed into it ends where it ends. Numbers are double; ImGui has no
/// word for that.
bool slider(Desk& desk, const std::string& name, double& value, double lo, double hi, const char* format,
            ImGuiSliderFlags flags = ImGuiSliderFlags_None) {
    ImGui::SetNextItemWidth(-1);
    const bool moved = ImGui::SliderScalar(("##" + name).c_str(), ImGuiDataType_Double, &value, &lo, &hi, format,
                                           flags | ImGuiSliderFlags_AlwaysClamp);
    mark(desk, name);
    return moved;
}

void show_time(Desk& desk) {
    const SourceState& state = desk.state;
    ImGui::TextUnformatted(fmt::format("t = {:.5g} s of {:.5g} s", state.time, state.last).c_str());
    if (desk.source.can_seek()) {
        double time = state.time;
        if (slider(desk, "time", time, state.first, state.last, "%.4g s")) {
            desk.source.play(false);
            desk.source.seek(time);
        }
    } else {
        const std::string pace = state.pace > 0 ? fmt::format(", {:.3g} of real time", state.pace) : "";
        const bool known = state.steps_per_s > 0; // else the line stays empty, so that nothing below it moves
        ImGui::TextUnformatted(known ? fmt::format("{:.3g} steps/s{}", state.steps_per_s, pace).c_str() : " ");
    }
}

void show_run(Desk& desk) {
    const SourceState& state = desk.state;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    const bool over = state.ended && !desk.source.can_seek();
    if (button(desk, "play", state.playing ? "Pause" : over ? "Ended" : "Play", third))
        desk.source.play(!state.playing);
    ImGui::SameLine();
    const bool back = desk.source.can_seek();
    if (button(desk, "step", back ? "Back" : "1 step", third))
        desk.source.step(back ? -1 : 1);
    ImGui::SameLine();
    if (button(desk, "steps", back ? "Forth" : "100", third))
        desk.source.step(back ? 1 : 100);
    show_time(desk);
    bool limited = state.speed > 0;
    double speed = limited ? state.speed : most_speed;
    if (!desk.source.can_seek()) {
        if (ImGui::Checkbox("hold a speed", &limited))
            desk.source.set_speed(limited ? 0.05 : 0);
        mark(desk, "hold speed");
    }
    if (limited && slider(desk, "speed", speed, least_speed, most_speed, "%.3g x real time",
                          ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat))
        desk.source.set_speed(speed);
}

void show_camera(Desk& desk) {
    const float quarter = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemSpacing.x) / 4;
    if (desk.layout.dimension == 2) {
        if (button(desk, "camera fit", "All of it"))
            desk.wishes.camera = "fit";
        return;
    }
    for (const char* name : {"front", "side", "top", "fit"}) {
        if (name != std::string_view("front"))
            ImGui::SameLine();
        if (button(desk, std::string("camera ") + name, name, quarter))
            desk.wishes.camera = name;
    }
}

/// One word of a few; true when another was chosen.
bool choose(Desk& desk, const std::string& name, const std::string& label, const std::vector<std::string>& words,
            std::string& chosen, const std::string& key, float width = -1) {
    bool changed = false;
    ImGui::SetNextItemWidth(width);
    const bool open = ImGui::BeginCombo(("##" + name).c_str(), (label + ": " + chosen).c_str());
    mark(desk, name);
    tell_key(desk, key);
    if (!open)
        return false;
    for (const std::string& word : words) {
        if (ImGui::Selectable(word.c_str(), word == chosen)) {
            changed = word != chosen;
            chosen = word;
        }
        mark(desk, name + " " + word);
    }
    ImGui::EndCombo();
    return changed;
}

void show_colors(Desk& desk) {
    std::vector<std::string> names;
    for (const render::Quantity& quantity : render::quantities())
        if (render::find_quantity(quantity.name, desk.layout.dimension))
            names.push_back(quantity.name);
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (choose(desk, "color", "colour", names, desk.look.color, "render.color", half)) {
        desk.look.range.reset();
        desk.wishes.restyle = true;
    }
    ImGui::SameLine();
    static const std::vector<std::string> maps = scene::find_key(*scene::find_table("render"), "colormap")->words;
    desk.wishes.restyle |= choose(desk, "colormap", "map", maps, desk.look.colormap, "render.colormap");
    bool fixed = desk.look.range.has_value();
    if (ImGui::Checkbox("fixed range", &fixed)) {
        desk.look.range = fixed ? std::optional(desk.range) : std::nullopt;
        desk.wishes.restyle = true;
    }
    mark(desk, "fixed range");
    tell_key(desk, "render.range");
    if (desk.look.color != "none") {
        ImGui::SameLine();
        desk.wishes.fit_range |= button(desk, "fit range", "Fit range now");
        tell_key(desk, "render.range");
    }
    if (!desk.look.range)
        return;
    std::array<double, 2> ends = *desk.look.range;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputScalarN("##range", ImGuiDataType_Double, ends.data(), 2, nullptr, nullptr, "%.4g",
                            ImGuiInputTextFlags_EnterReturnsTrue) &&
        std::isfinite(ends[0]) && std::isfinite(ends[1]) && ends[0] < ends[1]) {
        desk.look.range = ends;
        desk.wishes.restyle = true;
    }
    mark(desk, "range");
    tell_key(desk, "render.range");
}

void show_section(Desk& desk) {
    bool clipped = desk.look.clip.has_value();
    if (ImGui::Checkbox("only bodies between planes", &clipped)) {
        desk.look.clip =
            clipped ? std::optional(scene::Box{desk.layout.domain_lo, desk.layout.domain_hi}) : std::nullopt;
        desk.wishes.restyle = true;
    }
    mark(desk, "section");
    tell_key(desk, "render.clip_lo_m, render.clip_hi_m");
    if (!desk.look.clip)
        return;
    desk.wishes.restyle |= ImGui::Checkbox("cut bodies and walls there", &desk.look.clip_cuts);
    mark(desk, "cut");
    tell_key(desk, "render.clip_cuts");
    for (int axis = 0; axis < 3; ++axis) {
        const double lo = desk.layout.domain_lo[axis], hi = desk.layout.domain_hi[axis];
        const char letter = "xyz"[axis];
        double& low = desk.look.clip->lo[axis];
        double& high = desk.look.clip->hi[axis];
        bool moved = slider(desk, fmt::format("section {} from", letter), low, lo, hi,
                            fmt::format("{} from %.3g m", letter).c_str());
        tell_key(desk, "render.clip_lo_m");
        moved |= slider(desk, fmt::format("section {} to", letter), high, lo, hi,
                        fmt::format("{} to %.3g m", letter).c_str());
        tell_key(desk, "render.clip_hi_m");
        high = std::max(high, low + 1e-3 * (hi - lo)); // a section of no thickness holds nothing
        desk.wishes.restyle |= moved;
    }
}

/// With what was changed, camera and look included.
void offer_to_save(Desk& desk) {
    if (button(desk, "save scene", "Save as scene"))
        desk.wishes.save_scene = true;
    if (desk.saved.empty())
        return;
    ImGui::TextWrapped("%s", desk.saved.c_str());
    mark(desk, "saved");
    if (desk.saved_anew)
        ImGui::SetScrollHereY(1);
}

void show_controls(Desk& desk) {
    if (!desk.source.can_change()) {
        ImGui::TextWrapped("%s", desk.source.can_seek()
                                     ? "A run that is over cannot be changed. Its scene can be viewed."
                                     : "What Box2D remembers of its contacts is its own: its "
                                       "scenes cannot change while they run.");
        ImGui::TextWrapped("Its scene can be saved with this camera and look.");
        offer_to_save(desk);
        return;
    }
    bool changed = false;
    std::string before;
    const std::vector<Control>& all = desk.controls.all();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Control control = all[i];
        // The key's own table once over its sliders: "pair.media-lining", "wall.trough.motion.0".
        const std::string table =
            control.kind == Control::Kind::key ? control.key.substr(0, control.key.rfind('.')) : control.key;
        if (table != before)
            ImGui::TextDisabled("%s", table.c_str());
        before = table;
        const std::string name = control.kind == Control::Kind::key ? control.key : control.word;
        const std::string format = control.word + " %.4g " + control.unit;
        double value = control.value;
        if (slider(desk, name, value, control.lo, control.hi, format.c_str(), ImGuiSliderFlags_NoRoundToFormat)) {
            desk.controls.set(i, value);
            changed = true;
        }
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s, at first %.4g", desk.told_key.assign(control.key).c_str(), control.first);
    }
    if (desk.state.change_waits)
        ImGui::TextWrapped("A wall's new motion waits for the end of its period.");
    if (button(desk, "as in the scene", "As in the scene")) {
        desk.controls.reset();
        changed = true;
    }
    ImGui::SameLine();
    offer_to_save(desk);
    if (changed)
        desk.source.change(desk.controls.changes());
}

void show_plots(Desk& desk, const render::PanelCanvas& canvas, const render::Theme& theme) {
    render::ScreenPen pen(*ImGui::GetWindowDrawList(), canvas.fonts(), canvas.unit());
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const double width = room.x, gap = ImGui::GetStyle().ItemSpacing.y;
    const double share = room.y / std::max<double>(1, static_cast<double>(desk.plots.lines().size())) - gap;
    const double height = std::clamp(share, least_plot * canvas.unit(), most_plot * canvas.unit());
    for (const render::PlotLine& line : desk.plots.lines()) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({static_cast<float>(width), static_cast<float>(height)});
        if (ImGui::IsItemVisible())
            render::draw_plot(pen, {at.x, at.y, at.x + width, at.y + height}, line, desk.now, theme);
    }
    if (desk.plots.lines().empty())
        ImGui::TextWrapped("This run's series.csv has none of the measures plotted here.");
}

void show_keeping(Desk& desk) {
    if (button(desk, "picture", "PNG"))
        desk.wishes.picture = true;
    ImGui::SameLine();
    if (button(desk, "film", desk.state.filming ? "End the film" : "Film (MP4)"))
        (desk.state.filming ? desk.wishes.film_ends : desk.wishes.film) = true;
    for (const std::string& sentence : {desk.notice, desk.state.filmed})
        if (!sentence.empty())
            ImGui::TextWrapped("%s", sentence.c_str());
}

/// The scale of lines over the bodies: what occurs, here `found`, until a hand gives one.
void show_scale(Desk& desk, const std::string& name, const char* label, std::optional<double>& scale, double found,
                const char* format) {
    bool given = scale.has_value();
    if (ImGui::Checkbox(label, &given)) {
        scale = given ? std::optional(found) : std::nullopt;
        desk.wishes.restyle = true;
    }
    mark(desk, name);
    tell_key(desk, name);
    if (!scale)
        return;
    double typed = *scale;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputDouble(("##" + name).c_str(), &typed, 0, 0, format, ImGuiInputTextFlags_EnterReturnsTrue) &&
        std::isfinite(typed) && typed > 0) {
        scale = std::min(typed, largest_scale);
        desk.wishes.restyle = true;
    }
    mark(desk, name + " value");
}

void show_marks(Desk& desk) {
    scene::Marks& marks = desk.look.marks;
    ImGui::TextDisabled("over the bodies");
    desk.wishes.restyle |=
        choose(desk, "arrows", "velocities", {"none", "bodies", "field"}, marks.arrows, "render.arrows");
    if (marks.arrows != "none" && desk.key.arrow)
        show_scale(desk, "render.arrow_m_s", "arrows' scale", marks.arrow_speed, desk.key.arrow->speed, "%.4g m/s");
    std::string trail = marks.trails.empty() ? "none" : marks.trails.front();
    std::vector<std::string> names{"none"};
    for (const observe::FrameShape& shape : desk.layout.shapes)
        names.push_back(shape.name);
    if (choose(desk, "trail", "way of", names, trail, "render.trails")) {
        marks.trails.clear();
        if (trail != "none")
            marks.trails.push_back(trail);
        desk.wishes.restyle = true;
    }
    if (!desk.source.can_show_contacts()) {
        ImGui::TextWrapped("Force chains need a run with observe.contacts = true.");
        return;
    }
    desk.wishes.restyle |= ImGui::Checkbox("force chains", &marks.chains);
    mark(desk, "force chains");
    tell_key(desk, "render.force_chains, with observe.contacts");
    if (marks.chains && desk.key.chain)
        show_scale(desk, "render.chain_N", "chains' scale", marks.chain_force, desk.key.chain->force, "%.4g N");
}

void show_look(Desk& desk) {
    show_colors(desk);
    show_marks(desk);
    if (desk.layout.dimension == 3)
        show_section(desk);
}

bool begin_tab(Desk& desk, const char* name) {
    const bool shown = ImGui::BeginTabItem(name);
    mark(desk, std::string("tab ") + name);
    return shown;
}

void show_tabs(Desk& desk, const render::PanelCanvas& canvas, const render::Theme& theme) {
    if (!ImGui::BeginTabBar("tabs"))
        return;
    if (begin_tab(desk, "Plots")) {
        show_plots(desk, canvas, theme);
        ImGui::EndTabItem();
    }
    if (begin_tab(desk, "Change")) {
        show_controls(desk);
        ImGui::EndTabItem();
    }
    if (begin_tab(desk, "Look")) {
        show_look(desk);
        ImGui::EndTabItem();
    }
    if (begin_tab(desk, "Keep")) {
        show_keeping(desk);
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}

} // namespace

void lay_out_panel(Desk& desk, const render::PanelCanvas& canvas, const render::Theme& theme) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    show_run(desk);
    if (!desk.state.trouble.empty())
        ImGui::TextWrapped("%s", desk.state.trouble.c_str());
    if (!desk.warnings.empty()) {
        ImGui::TextWrapped("%s", desk.warnings.c_str());
        mark(desk, "warnings");
    }
    show_camera(desk);
    show_tabs(desk, canvas, theme);
    ImGui::End();
}

} // namespace tumble::view
