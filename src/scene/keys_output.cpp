#include "scene/key_maker.h"

#include <numbers>

namespace tumble::scene {
namespace {

KeyTable observe() {
    KeyTable table{.path = "observe", .head = "[observe]"};
    table.sentence = "What is written to `series.csv`, and what frames keep beside bodies and walls.";
    table.keys = {
        number("every_s", "s", above(0, 1e6), "Time between rows.").otherwise(0.01),
        words("measures", {},
              "Which measures, by name or group; `tumble list measures` names them. Without it the usual ones, which "
              "docs/measures.md lists; `tracer:BODY` follows the first body of that name.")
            .otherwise(std::vector<std::string>{}),
        flag("contacts",
             "Frames keep every contact: who touches whom, where, and with what force. `force_chains` draws "
             "them."),
        number(
            "axes_turned_deg", "deg", from(-45, 45),
            "How far the axes that `centre_of_mass_x` and `_y` are read along are turned about z through the origin, "
            "counter-clockwise: what a camera sees that does not stand upright.")
            .si(std::numbers::pi / 180)
            .otherwise(0.0),
    };
    return table;
}

KeyTable render() {
    KeyTable table{.path = "render", .head = "[render]"};
    table.sentence = "How pictures and the video are drawn; changes nothing in the run.";
    table.keys = {
        word("camera", {"front", "top", "side", "free"},
             "front looks along x at the trough's cross-section, top down on it, side across it; free is placed by "
             "`eye_m` and `target_m`, both or neither; without them it looks from the front, right and above.")
            .in_3d()
            .otherwise(std::string("front")),
        word("projection", {"orthographic", "perspective"}, "Parallel or with vanishing points.")
            .in_3d()
            .otherwise(std::string("orthographic")),
        vector("eye_m", "m", from(-1e4, 1e4), "Where a free camera stands.")
            .in_3d()
            .otherwise(std::vector<double>{0, 0, 0}),
        vector("target_m", "m", from(-1e4, 1e4), "What a free camera looks at.")
            .in_3d()
            .otherwise(std::vector<double>{0, 0, 0}),
        number("field_of_view_deg", "deg", from(1, 170), "Opening of a perspective camera, vertical.")
            .in_3d()
            .otherwise(35.0),
        number("turn_deg_s", "deg/s", from(-1e5, 1e5),
               "How fast, by the scene's time, a free camera goes around what it looks at, about the upward axis; "
               "above 0 anticlockwise as seen from above.")
            .in_3d()
            .otherwise(0.0),
        vector("view_lo_m", "m", from(-1e4, 1e4),
               "Lowest corner of what must be in the picture; without it all walls "
               "and bodies."),
        vector("view_hi_m", "m", from(-1e4, 1e4), "Highest corner of it."),
        vector("clip_lo_m", "m", from(-1e4, 1e4),
               "Lowest corner of a box: bodies whose centres lie outside are not drawn, which shows a section.")
            .in_3d(),
        vector("clip_hi_m", "m", from(-1e4, 1e4), "Highest corner of it.").in_3d(),
        flag("clip_cuts",
             "The box, and sections, cut bodies and walls open instead of leaving out whole bodies: where a face "
             "cuts, a body is flat and a little darker, and a wall ends in a line.")
            .in_3d(),
        word("color", {"speed", "vx", "vy", "vz", "spin", "none"},
             "Quantity that colours the bodies; with none they are all alike and pale, for what is drawn over them.")
            .otherwise(std::string("speed")),
        KeyMaker(
            "range", KeyType::span, "", {},
            "Values at the two ends of the colour scale, in the quantity's SI unit; without it what occurs. It goes "
            "with the `color` beside it: a command line that names another colour and no range leaves it out."),
        word("colormap", {"auto", "viridis", "cividis", "inferno", "coolwarm"},
             "Colour scale; auto is coolwarm for quantities with a sign, else viridis.")
            .otherwise(std::string("auto")),
        word("arrows", {"none", "bodies", "field"},
             "Velocities in the plane of the picture: of bodies, of so many that the picture stays readable; or the "
             "mean "
             "over the frames drawn, on a grid.")
            .otherwise(std::string("none")),
        number("arrow_m_s", "m/s", above(0, 1e6), "Speed of the legend's arrow; without it what occurs."),
        flag("force_chains",
             "Lines between bodies that touch, as thick as the normal force; needs `observe.contacts`."),
        number("chain_N", "N", above(0, 1e12), "Normal force of the thickest line; without it what occurs."),
        words("trails", {}, "Bodies whose way is drawn, through the frames up to now: the first of a name, or by id.")
            .otherwise(std::vector<std::string>{}),
        word("style", {"screen", "paper"},
             "paper is for print: white, `width_mm` x `height_mm` at `dpi`, letters of `font_pt`, without the title.")
            .otherwise(std::string("screen")),
        word("background", {"dark", "white"}, "Behind the picture.").otherwise(std::string("dark")),
        integer("width_px", from(64, 8192), "Width of the picture.").otherwise(std::int64_t{1280}),
        integer("height_px", from(64, 8192), "Height of the picture.").otherwise(std::int64_t{720}),
        number("width_mm", "mm", from(20, 600), "Width of a picture for print.").otherwise(85.0),
        number("height_mm", "mm", from(15, 600), "Height of it.").otherwise(60.0),
        number("dpi", "", from(72, 1200), "Pixels an inch of it; the PNG file says so.").otherwise(300.0),
        number("font_pt", "pt", from(4, 24), "Size of its smallest letters, those of the numbers at scales.")
            .otherwise(8.0),
        number("every_s", "s", above(0, 1e6), "Simulated time between frames.").otherwise(0.04),
        number("frames_per_second", "1/s", above(0, 240), "Frames of the video per second of watching.")
            .otherwise(25.0),
        flag("plot", "Draw a small live plot over the picture; without it one is drawn on a screen's, none on paper."),
        text("plot_measure", "The one measure it shows, or a column of a tracer, as `tracer:sensor_y`.")
            .otherwise(std::string("kinetic_energy")),
    };
    return table;
}

} // namespace

std::vector<KeyTable> output_tables() {
    return {observe(), render()};
}

} // namespace tumble::scene
