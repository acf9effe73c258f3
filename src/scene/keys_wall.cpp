#include "scene/key_maker.h"

#include <numbers>

namespace tumble::scene {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;
constexpr double radians_per_second_per_rpm = 2 * std::numbers::pi / 60;

std::vector<Key> straight_trough() {
    return {
        number("floor_m", "m", from(-1e4, 1e4), "Height (y) of its lowest line.").only_for({"trough"}).must(),
        number("rim_m", "m", from(-1e4, 1e4), "Height (y) of its rim.").only_for({"trough"}).must(),
        number("flare_deg", "deg", from(0, 80), "How far the sides lean outwards from the vertical.")
            .si(radians_per_degree)
            .only_for({"trough"})
            .otherwise(0.0),
        number("x_lo_m", "m", from(-1e4, 1e4),
               "Where drawing and export begin it; contact has no end along x. "
               "Without it the domain's end.")
            .only_for({"trough"})
            .in_3d(),
        number("x_hi_m", "m", from(-1e4, 1e4), "Where drawing and export end it.").only_for({"trough"}).in_3d(),
    };
}

std::vector<Key> stl_mesh() {
    return {
        file("stl", "Triangles, ASCII or binary STL.").only_for({"mesh"}).in_3d().must(),
        number("scale", "", above(0, 1e6), "Metres per unit of the file: 0.001 for millimetres.")
            .only_for({"mesh", "hexahedra"})
            .in_3d()
            .otherwise(1.0),
    };
}

std::vector<Key> lines_in_the_plane() {
    return {
        vector("from_m", "m", from(-1e4, 1e4), "One end.").only_for({"segment"}).in_2d().must(),
        vector("to_m", "m", from(-1e4, 1e4), "The other end.").only_for({"segment"}).in_2d().must(),
        rows("points_m", "m", 2, from(-1e4, 1e4), "Its corners: [[x, y], ...], two or more.")
            .only_for({"polyline"})
            .in_2d()
            .must(),
        flag("closed", "True: the last point is joined to the first.").only_for({"polyline"}).in_2d(),
        vector("centre_m", "m", from(-1e4, 1e4), "Centre of the circle.").only_for({"arc"}).in_2d().must(),
        number("from_deg", "deg", from(-360, 360), "Where it begins, counter-clockwise from the x axis.")
            .si(radians_per_degree)
            .only_for({"arc"})
            .in_2d()
            .otherwise(0.0),
        number("sweep_deg", "deg", above(0, 360), "How far it goes counter-clockwise; 360: the whole circle.")
            .si(radians_per_degree)
            .only_for({"arc"})
            .in_2d()
            .otherwise(360.0),
    };
}

/// What no drawing of the machine says has a default; docs/bowl.md gives the reasons.
std::vector<Key> rotary_bowl() {
    const std::vector<std::string> both{"bowl", "bowl-disc"};
    return {
        number("height_m", "m", above(0, 1e4), "Height of the wall.").only_for({"bowl"}).in_3d().must(),
        number("rim_width_m", "m", above(0, 1e4), "How far the inclined rim reaches, along the radius.")
            .only_for({"bowl-disc"})
            .in_3d()
            .otherwise(0.03),
        number("rim_rise_m", "m", from(0, 1e4), "How far it rises; 0: a flat disc.")
            .only_for({"bowl-disc"})
            .in_3d()
            .otherwise(0.03),
        integer("rib_count", from(0, 360), "Number of ribs; 0: a smooth surface.")
            .only_for(both)
            .in_3d()
            .otherwise(std::int64_t{12}),
        number("rib_start", "", from(0, 0.95),
               "Where ribs begin: a share of the wall's height, or of the disc's radius.")
            .only_for(both)
            .in_3d()
            .otherwise(0.25),
        number("rib_height_m", "m", above(0, 1e4), "How far they stand off the surface.")
            .only_for(both)
            .in_3d()
            .otherwise(0.004),
        number("rib_width_m", "m", above(0, 1e4), "Their width at the foot.").only_for(both).in_3d().otherwise(0.012),
        number("rib_crest_m", "m", above(0, 1e4), "Their width at the crest.").only_for(both).in_3d().otherwise(0.006),
    };
}

/// The defaults are the thesis' meshes (figures 7.16 and 7.32) and its steel (figure 7.8); docs/stress.md.
std::vector<Key> specimens() {
    const std::vector<std::string> cylinder{"bored-cylinder"}, prism{"prism"}, both{"bored-cylinder", "prism"},
        file_part{"hexahedra"}, all{"bored-cylinder", "prism", "hexahedra"};
    return {
        file("inp",
             "Hexahedra of a CalculiX or Abaqus file (*NODE, *ELEMENT of type C3D8, *NSET), or of gmsh where its name "
             "ends in .msh (format 2.2 or 4.1, ASCII).")
            .only_for(file_part)
            .in_3d()
            .must(),
        text("held_set",
             "Node set of that file, or physical group of gmsh, that cannot move when `tumble stress` solves it.")
            .only_for(file_part)
            .in_3d()
            .must(),
        number("bore_radius_m", "m", above(0, 1e4), "Radius of the through hole.").only_for(cylinder).in_3d().must(),
        number("shell_m", "m", above(0, 1e4), "Thickness of the outer shell, which has rings of its own.")
            .only_for(cylinder)
            .in_3d()
            .otherwise(0.0015),
        integer("around", from(3, 1000), "Hexahedra about the axis.")
            .only_for(cylinder)
            .in_3d()
            .otherwise(std::int64_t{60}),
        integer("along", from(1, 10000), "Hexahedra along the axis.").only_for(both).in_3d().must(),
        integer("shell_rings", from(1, 1000), "Hexahedra across the shell.")
            .only_for(cylinder)
            .in_3d()
            .otherwise(std::int64_t{3}),
        integer("inner_rings", from(1, 1000), "Hexahedra between bore and shell.")
            .only_for(cylinder)
            .in_3d()
            .otherwise(std::int64_t{6}),
        number("side_m", "m", above(0, 1e4), "Side of its square base.").only_for(prism).in_3d().must(),
        number("corner_m", "m", above(0, 1e4), "How much of a side, at either end, is refined.")
            .only_for(prism)
            .in_3d()
            .otherwise(0.0048),
        integer("corner_cells", from(1, 1000), "Hexahedra across each refined end.")
            .only_for(prism)
            .in_3d()
            .otherwise(std::int64_t{6}),
        integer("middle_cells", from(1, 1000), "Hexahedra between them.")
            .only_for(prism)
            .in_3d()
            .otherwise(std::int64_t{10}),
        word("held", {"base", "top", "both"}, "Which of its ends cannot move when `tumble stress` solves it.")
            .only_for(both)
            .in_3d()
            .otherwise(std::string{"top"}),
        number("part_youngs_modulus_Pa", "Pa", above(0, 1e13),
               "Young's modulus of the part when it is solved; `material` is what bodies feel.")
            .only_for(all)
            .in_3d()
            .otherwise(2e11),
        number("part_poisson_ratio", "", from(0, 0.49), "Its Poisson ratio.").only_for(all).in_3d().otherwise(0.3),
    };
}

KeyTable wall() {
    KeyTable table{.path = "wall", .head = "[[wall]]", .repeat = Repeat::many, .kind_key = "shape"};
    table.sentence = "A surface that bodies cannot pass.";
    table.keys = {
        text("name", "Its name, used by `--set wall.NAME.key=value`, series and pictures.").must(),
        word("shape",
             {"plane", "box", "cylinder", "disc", "trough", "mesh", "bowl", "bowl-disc", "bored-cylinder", "prism",
              "hexahedra"},
             "plane: unbounded, one-sided. box: touched from inside. cylinder: lateral surface without lids. disc: a "
             "thin round plate. trough: a U along x, half a cylinder below straight sides. mesh: triangles of an STL "
             "file. bowl, bowl-disc: the wall and the bottom of a rotary bowl about the y axis. bored-cylinder, prism, "
             "hexahedra: specimens, for `tumble stress`. May be left out when `stl` is given.")
            .in_3d()
            .must(),
        word("shape", {"segment", "arc", "polyline", "box", "trough"},
             "segment: a straight line between two points. arc: a circle or a part of one. polyline: straight lines "
             "from "
             "point to point. box: four sides. trough: a U, an arc below straight sides, about x = 0. All are touched "
             "from both sides.")
            .in_2d()
            .must(),
        text("material", "Name of its material.").must(),
        number("opacity", "", from(0, 1), "How solid it looks in pictures; 0 is invisible.").in_3d().otherwise(0.25),

        vector("point_m", "m", from(-1e4, 1e4), "Any point of the plane.").only_for({"plane"}).in_3d().must(),
        vector("normal", "", from(-1e6, 1e6), "Direction away from the surface, towards the bodies; any length.")
            .only_for({"plane", "disc"})
            .in_3d()
            .otherwise(std::vector<double>{0, 1, 0}),
        vector("lo_m", "m", from(-1e4, 1e4), "Lowest corner.").only_for({"box"}).must(),
        vector("hi_m", "m", from(-1e4, 1e4), "Highest corner.").only_for({"box"}).must(),
        words("open", {"-x", "+x", "-y", "+y", "-z", "+z"}, "Faces that are left out.")
            .only_for({"box"})
            .in_3d()
            .otherwise(std::vector<std::string>{}),
        words("open", {"-x", "+x", "-y", "+y"}, "Sides that are left out.")
            .only_for({"box"})
            .in_2d()
            .otherwise(std::vector<std::string>{}),
        vector("base_m", "m", from(-1e4, 1e4), "Centre of the end that `axis` starts at; of a bowl: of its lower edge.")
            .only_for({"cylinder", "bowl", "bored-cylinder", "prism"})
            .in_3d()
            .must(),
        vector("axis", "", from(-1e6, 1e6), "Direction of the axis; any length.")
            .only_for({"cylinder", "bored-cylinder", "prism", "hexahedra"})
            .in_3d()
            .otherwise(std::vector<double>{0, 1, 0}),
        number("length_m", "m", above(0, 1e4), "Length along the axis.")
            .only_for({"cylinder", "bored-cylinder", "prism"})
            .in_3d()
            .must(),
        vector("centre_m", "m", from(-1e4, 1e4), "Centre of the plate; of a bowl-disc: of its flat part.")
            .only_for({"disc", "bowl-disc"})
            .in_3d()
            .must(),
        number("radius_m", "m", above(0, 1e4),
               "Radius; of the trough: of its bottom; of a bowl-disc: of its rim's edge, the gap to the wall taken "
               "off; of a bored-cylinder: of the circle on which its outer corners lie.")
            .only_for({"cylinder", "disc", "trough", "bowl", "bowl-disc", "bored-cylinder"})
            .in_3d()
            .must(),
        number("radius_m", "m", above(0, 1e4), "Radius; of the trough: of its bottom.")
            .only_for({"arc", "trough"})
            .in_2d()
            .must(),
        number("hole_radius_m", "m", from(0, 1e4), "Radius of a round hole in the middle; 0: none.")
            .only_for({"disc"})
            .in_3d()
            .otherwise(0.0),
    };
    for (const auto& part : {straight_trough(), stl_mesh(), lines_in_the_plane(), rotary_bowl(), specimens()})
        table.keys.insert(table.keys.end(), part.begin(), part.end());
    return table;
}

KeyTable motion() {
    KeyTable table{.path = "wall.motion", .head = "[[wall.motion]]", .repeat = Repeat::many, .kind_key = "kind"};
    table.sentence =
        "How the wall above it moves. All motions of a wall superpose, each a pure function of time; after "
        "`stop_s` a motion holds what it had reached.";
    table.keys = {
        word("kind", {"harmonic", "harmonics", "rotation", "rocking", "linear", "table"},
             "harmonic: a (sin(2 pi f (t - start) + phase) - sin(phase)) along an axis. harmonics: many of them, one a "
             "line of a file. rotation: constant speed about an axis (2D: about a point, counter-clockwise where "
             "positive). rocking: a harmonic angle about it. linear: constant velocity. table: a measured "
             "displacement.")
            .must(),
        number("start_s", "s", from(0, 1e6), "When it begins; time inside the motion counts from here.").otherwise(0.0),
        number("stop_s", "s", above(0, 1e6), "When it ends; without it never."),
        word("axis", {"x", "y", "z"}, "Direction of the displacement.").only_for({"harmonic"}).in_3d().must(),
        word("axis", {"x", "y"}, "Direction of the displacement.").only_for({"harmonic"}).in_2d().must(),
        number("amplitude_m", "m", from(0, 100), "Largest displacement.").only_for({"harmonic"}).must(),
        number("amplitude_deg", "deg", from(0, 360), "Largest angle.")
            .si(radians_per_degree)
            .only_for({"rocking"})
            .must(),
        number("frequency_Hz", "Hz", above(0, 1e6), "Cycles per second.").only_for({"harmonic", "rocking"}).must(),
        number("drift_Hz_s", "Hz/s", from(-1e6, 1e6),
               "How fast that frequency rises, from `start_s` on; over the run it may neither double nor vanish.")
            .only_for({"harmonic", "rocking"})
            .otherwise(0.0),
        number("phase_deg", "deg", from(-360, 360),
               "Phase at the start; 90 is a quarter period ahead. Of harmonics: added to the phase of each.")
            .si(radians_per_degree)
            .only_for({"harmonic", "rocking", "harmonics"})
            .otherwise(0.0),
        vector("centre_m", "m", from(-1e4, 1e4), "A point of the axis, where the wall stands at rest.")
            .only_for({"rotation", "rocking"})
            .must(),
        vector("about", "", from(-1e6, 1e6), "Direction of the axis, right-handed; any length.")
            .only_for({"rotation", "rocking"})
            .in_3d()
            .must(),
        number("speed_rpm", "rpm", from(-1e5, 1e5), "Turns per minute.")
            .si(radians_per_second_per_rpm)
            .only_for({"rotation"})
            .one_of("speed"),
        number("speed_rad_s", "rad/s", from(-1e4, 1e4), "The same in radians per second.")
            .only_for({"rotation"})
            .one_of("speed"),
        vector("velocity_m_s", "m/s", from(-1e3, 1e3), "Velocity.").only_for({"linear"}).must(),
        rows("rows", "s, m, m, m", 4, {}, "The table written out: [[t, x, y, z], ...], time from 0, rising.")
            .only_for({"table"})
            .in_3d()
            .one_of("table"),
        rows("rows", "s, m, m", 3, {}, "The table written out: [[t, x, y], ...], time from 0, rising.")
            .only_for({"table"})
            .in_2d()
            .one_of("table"),
        file("file",
             "harmonics: CSV with the head `axis,amplitude,period` and, if phases are known, `phase_deg`; metres "
             "and seconds. table: CSV with the head `t_s,x_m,y_m,z_m`, without `z_m` in two dimensions.")
            .only_for({"harmonics", "table"})
            .one_of("table"),
        number("amplitude_factor", "", from(0, 1000),
               "What every displacement of the file or the rows is multiplied by.")
            .only_for({"harmonics", "table"})
            .otherwise(1.0),
        number("frequency_factor", "", above(0, 1000), "How many times as fast the file's or the rows' motion goes.")
            .only_for({"harmonics", "table"})
            .otherwise(1.0),
    };
    return table;
}

} // namespace

std::vector<KeyTable> wall_tables() {
    return {wall(), motion()};
}

} // namespace tumble::scene
