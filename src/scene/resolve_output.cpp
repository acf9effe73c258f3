#include "scene/resolve.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::scene {
namespace {

bool is_number(const std::string& word) {
    return !word.empty() && word.size() < 16 &&
           std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

void resolve_marks(const View& view, const Resolving& to) {
    Marks& marks = to.scene.render.marks;
    marks.arrows = view.text("arrows");
    if (view.given("arrow_m_s"))
        marks.arrow_speed = view.number("arrow_m_s");
    marks.chains = view.flag("force_chains");
    if (marks.chains && !to.scene.observe.contacts)
        to.refuse(view, "force_chains", "force chains are drawn from contacts, which the frames do not keep",
                  "write contacts = true in [observe]; a run that is over must be run again with it");
    if (view.given("chain_N"))
        marks.chain_force = view.number("chain_N");
    marks.trails = view.words("trails");
    std::vector<std::string> names;
    for (const BodyTemplate& body : to.scene.bodies)
        names.push_back(body.name);
    for (auto trail = marks.trails.begin(); trail != marks.trails.end(); ++trail)
        if (std::find(marks.trails.begin(), trail, *trail) != trail) {
            to.refuse(view, "trails", fmt::format("'{}' is given twice", *trail), "name each body once");
            break;
        }
    for (const std::string& trail : marks.trails)
        if (!is_number(trail) && std::find(names.begin(), names.end(), trail) == names.end())
            to.refuse(view, "trails", fmt::format("no body is called '{}'", trail),
                      fmt::format("take {}, or a body's id as \"0\"", fmt::join(names, ", ")));
}

// Units of lettering (src/render/layout.h) that a picture must be wide and high, and pixels that it may have a side.
constexpr double least_units_wide = 300;
constexpr double least_units_high = 200;
constexpr int fewest_pixels = 64;
constexpr int most_pixels = 8192;

void check_size(const View& view, const Paper& paper, const Resolving& to) {
    const Render& render = to.scene.render;
    const auto fits = [](int pixels) { return pixels >= fewest_pixels && pixels <= most_pixels; };
    if (!fits(render.width) || !fits(render.height))
        to.refuse(view, "dpi",
                  fmt::format("{:.4g} x {:.4g} mm at {:.4g} dpi are {} x {} pixels", paper.width_mm, paper.height_mm,
                              paper.dpi, render.width, render.height),
                  fmt::format("choose them so that each side has {} to {}", fewest_pixels, most_pixels));
    const double room = std::min(paper.width_mm / least_units_wide, paper.height_mm / least_units_high); // mm a unit
    // Numbers at scales are 17 units from their lowest to their highest reach, 1.164 of their size in points.
    const double points_a_unit = 17 / 1.164 / 25.4 * 72; // and a mm
    const double most = std::floor(2 * room * points_a_unit) / 2;
    const double needed = std::ceil(2 * paper.font_pt) / 2 / points_a_unit; // mm a unit
    if (paper.font_pt > most)
        to.refuse(view, "font_pt",
                  fmt::format("letters of {:.3g} pt leave no room for the scene in {:.4g} x {:.4g} mm", paper.font_pt,
                              paper.width_mm, paper.height_mm),
                  fmt::format("take at most {:.3g} pt, or at least {:.0f} x {:.0f} mm", most,
                              std::max(paper.width_mm, std::ceil(needed * least_units_wide)),
                              std::max(paper.height_mm, std::ceil(needed * least_units_high))));
}

void resolve_size(const View& view, const Resolving& to) {
    Render& render = to.scene.render;
    render.background = view.text("background");
    if (view.text("style") != "paper") {
        for (const char* key : {"width_mm", "height_mm", "dpi", "font_pt"})
            if (view.written(key))
                to.refuse(view, key, "a size in mm, dpi and points belongs to a picture for print",
                          "write style = \"paper\" beside it, or width_px and height_px in its place");
        render.width = static_cast<int>(view.integer("width_px"));
        render.height = static_cast<int>(view.integer("height_px"));
        return;
    }
    for (const char* key : {"width_px", "height_px"})
        if (view.written(key))
            to.refuse(view, key, "a picture for print has its size in mm, and its pixels from dpi",
                      "write width_mm, height_mm and dpi in its place");
    if (view.written("background") && render.background != "white")
        to.refuse(view, "background", "a picture for print is white", "leave it out, or write style = \"screen\"");
    render.background = "white";
    const Paper paper{view.number("width_mm"), view.number("height_mm"), view.number("dpi"), view.number("font_pt")};
    render.paper = paper;
    render.width = static_cast<int>(std::lround(paper.width_mm / 25.4 * paper.dpi));
    render.height = static_cast<int>(std::lround(paper.height_mm / 25.4 * paper.dpi));
    check_size(view, paper, to);
}

void resolve_render(const View& view, const Resolving& to) {
    Render& render = to.scene.render;
    render.camera = to.scene.dimension == 2 ? "side" : view.text("camera"); // along -z: x to the right, y up
    render.projection = view.text("projection");
    render.eye = view.vector("eye_m");
    render.target = view.vector("target_m");
    render.field_of_view_deg = view.number("field_of_view_deg");
    if (view.given("view_lo_m") && view.given("view_hi_m")) {
        render.view = box_of(view, "view_lo_m", "view_hi_m", to);
        if (!has_volume(*render.view))
            to.refuse(view, "view_hi_m", "the view has no volume",
                      "each value of view_hi_m must be above that of view_lo_m");
    } else if (view.written("view_lo_m") != view.written("view_hi_m"))
        to.refuse(view, view.written("view_lo_m") ? "view_lo_m" : "view_hi_m", "a view needs both of its corners",
                  "give view_lo_m and view_hi_m");
    if (view.given("clip_lo_m") && view.given("clip_hi_m")) {
        render.clip = box_of(view, "clip_lo_m", "clip_hi_m", to);
        if (!has_volume(*render.clip))
            to.refuse(view, "clip_hi_m", "the clip has no volume",
                      "each value of clip_hi_m must be above that of clip_lo_m");
    } else if (view.written("clip_lo_m") != view.written("clip_hi_m"))
        to.refuse(view, view.written("clip_lo_m") ? "clip_lo_m" : "clip_hi_m", "a clip needs both of its corners",
                  "give clip_lo_m and clip_hi_m");
    render.clip_cuts = view.flag("clip_cuts");
    const bool has_eye = view.written("eye_m"), has_target = view.written("target_m");
    if (render.camera == "free" && has_eye != has_target)
        to.refuse(view, has_eye ? "eye_m" : "target_m",
                  has_eye ? "a free camera that stands somewhere needs what it looks at"
                          : "a free camera that looks at something needs where it stands",
                  fmt::format("give {} too, or neither to look from the front, right and above",
                              has_eye ? "target_m" : "eye_m"));
    else if (render.camera == "free" && has_eye && render.eye == render.target)
        to.refuse(view, "camera", "a free camera stands where it looks at",
                  "give eye_m and target_m, two different points, or neither to look from the front, right and above");
    resolve_marks(view, to);
    render.turn_deg_s = view.number("turn_deg_s");
    if (render.turn_deg_s != 0 && render.camera != "free")
        to.refuse(view, "turn_deg_s", "only a free camera turns", "write camera = \"free\", or turn_deg_s = 0");
    if (render.turn_deg_s != 0 && render.marks.arrows == "field")
        to.refuse(view, "turn_deg_s", "a mean field belongs to a camera that stands still",
                  "write arrows = \"bodies\", or turn_deg_s = 0");
    render.color = view.text("color");
    if (view.given("range")) {
        const auto ends = view.numbers("range");
        render.range = std::array<double, 2>{ends[0], ends[1]};
    }
    render.colormap = view.text("colormap");
    resolve_size(view, to);
    render.every = view.number("every_s");
    render.frames_per_second = view.number("frames_per_second");
    render.plot = view.written("plot") ? view.flag("plot") : !render.paper;
    render.plot_measure = view.text("plot_measure");
}

} // namespace

void resolve_output(const View& root, const Resolving& to) {
    const View observe = root.child("observe");
    to.scene.observe.every = observe.number("every_s");
    to.scene.observe.measures = observe.words("measures");
    to.scene.observe.contacts = observe.flag("contacts");
    to.scene.observe.axes_turned = observe.number("axes_turned_deg");
    resolve_render(root.child("render"), to);
}

} // namespace tumble::scene
