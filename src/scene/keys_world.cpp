#include "scene/key_maker.h"
#include "scene/laws.h"

namespace tumble::scene {
namespace {

KeyTable top_level() {
    KeyTable table{.path = "", .head = "", .required = true};
    table.sentence = "Keys at the top of the file, before the first table.";
    table.keys = {
        text("title", "What the run is called in pictures and reports.").otherwise(std::string()),
        text("claim", "What this scene shows, and where the number comes from.").otherwise(std::string()),
        integer("dimension", from(2, 3), "How many directions bodies move in.").otherwise(std::int64_t{3}),
        number("depth_m", "m", above(0, 1e4), "Length of discs and walls across the plane: masses are kg and forces N.")
            .in_2d()
            .must(),
        word("solver", {"soft", "box2d"},
             "What moves the discs: \"soft\" contacts of springs and dashpots, or the hard ones of Box2D "
             "(docs/hard-contacts.md).")
            .in_2d()
            .otherwise(std::string("soft")),
        number("duration_s", "s", above(0, 1e6), "Simulated time from start to end.").must(),
        number("time_step_s", "s", above(0, 1), "Length of one step; `tumble check` says what is stable.").must(),
        flag("allow_large_step", "Run even when the step is above the stable limit."),
        integer("seed", from(0, 9007199254740992), "Starts the random numbers; the same seed gives the same run.")
            .otherwise(std::int64_t{1}),
        vector("gravity_m_s2", "m/s2", from(-1e4, 1e4), "Gravity; y is up.")
            .otherwise(std::vector<double>{0, -9.81, 0}),
        number("skin_m", "m", from(0, 1),
               "Extra reach of the body neighbour list; 0: the solver chooses. "
               "Changes the time a run takes, never its contacts.")
            .otherwise(0.0),
        flag("turn_spheres",
             "False: bodies of one sphere are recorded as if they did not turn, which saves time; their "
             "spin and all forces are the same. A tracer in one then reads along fixed axes.")
            .otherwise(true)
            .in_3d(),
    };
    return table;
}

KeyTable domain() {
    KeyTable table{.path = "domain", .head = "[domain]", .required = true};
    table.sentence = "The box that bodies live in. A body that leaves it through a side that is not periodic stops the "
                     "run.";
    table.keys = {
        vector("lo_m", "m", from(-1e4, 1e4), "Lowest corner.").must(),
        vector("hi_m", "m", from(-1e4, 1e4), "Highest corner.").must(),
        words("periodic", {"x", "y", "z"}, "Directions in which what leaves at one end enters at the other.")
            .in_3d()
            .otherwise(std::vector<std::string>{}),
        words("periodic", {"x", "y"}, "Directions in which what leaves at one end enters at the other.")
            .in_2d()
            .otherwise(std::vector<std::string>{}),
    };
    return table;
}

KeyTable box2d() {
    KeyTable table{.path = "box2d", .head = "[box2d]"};
    table.sentence = "How Box2D works, where `solver = \"box2d\"`; docs/hard-contacts.md says what its contacts are.";
    table.keys = {
        number(
            "time_step_s", "s", above(0, 1),
            "Length of one step of Box2D; without it the shortest of: a fall from rest through Box2D's slop, half of "
            "the smallest radius at the fastest impact, a fortieth of a wall's period; rounded down.")
            .in_2d(),
        integer("velocity_iterations", from(1, 1000), "How often a step goes over all contacts to agree on impulses.")
            .in_2d()
            .otherwise(std::int64_t{20}),
        integer("position_iterations", from(1, 1000), "How often a step goes over all contacts to take overlaps back.")
            .in_2d()
            .otherwise(std::int64_t{8}),
        number("rebound_above_m_s", "m/s", from(0, 1e4),
               "Slower impacts do not rebound; without it twice the speed that gravity adds in a step, so that what "
               "rests does not bounce.")
            .in_2d(),
    };
    return table;
}

KeyTable contact() {
    KeyTable table{.path = "contact", .head = "[contact]"};
    table.sentence = "The laws that push touching spheres or discs apart.";
    table.keys = {
        word("normal", {"hertz", "linear"},
             "Normal force: \"hertz\" from Young's modulus, or \"linear\" spring-dashpot from a stiffness.")
            .in_3d()
            .otherwise(std::string("hertz")),
        word("normal", {"linear", "hertz"},
             "Normal force: \"linear\" spring and dashpot of Cundall and Strack, or \"hertz\" between spheres of the "
             "discs' radii.")
            .in_2d()
            .otherwise(std::string("linear")),
        word("tangential", {"mindlin", "linear", "none"},
             "Tangential force with history; \"mindlin\" goes with \"hertz\", \"linear\" takes its own stiffness.")
            .in_3d()
            .otherwise(std::string("mindlin")),
        word("tangential", {"linear", "mindlin", "none"},
             "Tangential force with history; \"linear\" goes with \"linear\", \"mindlin\" with \"hertz\".")
            .in_2d()
            .otherwise(std::string("linear")),
        word("rolling", {words_of_rolling.begin(), words_of_rolling.end()},
             "Resistance against rolling of pairs with a `rolling_friction`: \"cdt\" constant directional torque, "
             "\"epsd\" elastic-plastic spring-dashpot.")
            .otherwise(std::string("none")),
        word("adhesion", {words_of_adhesion.begin(), words_of_adhesion.end()},
             "Attraction of touching surfaces: \"sjkr\" by contact area from a `cohesion_energy_J_m3`, \"jkr\" and "
             "\"dmt\" from a `work_of_adhesion_J_m2`; these two go with `normal = \"hertz\"`.")
            .in_3d()
            .otherwise(std::string("none")),
        flag("limit_force", "True: the normal force never pulls at the end of a rebound."),
        flag("share_among_body_contacts",
             "True: n contacts of one body pair share one dashpot, each damps 1/sqrt(n) as much; their springs add up.")
            .in_3d(),
        number("damping_shared", "", from(0, 1),
               "The same to a degree x: each of n contacts of one body pair damps n^(-x/2) as much; 1 is "
               "`share_among_body_contacts`.")
            .in_3d()
            .otherwise(0.0),
        number("global_damping_per_s", "1/s", from(0, 1e6),
               "Mass-proportional damping of every body's motion, alpha of Cundall and Strack: a force -alpha m v.")
            .in_2d()
            .otherwise(0.0),
        number("accepted_overlap", "", above(0, 1),
               "Deepest overlap, as a share of the smaller radius, that the scene expects; `run` warns beyond it. More "
               "than a few percent is a price of soft materials.")
            .otherwise(0.05),
    };
    return table;
}

KeyTable air() {
    KeyTable table{.path = "air", .head = "[air]"};
    table.sentence =
        "Still air, or another medium at rest, that drags on every body as on the sphere of its volume, or the "
        "disc of its area. It neither carries bodies up nor turns them.";
    table.keys = {
        number("density_kg_m3", "kg/m3", from(0, 2e4),
               "Density, for the drag rho C_d / 2 A v^2; that of air is 1.2 kg/m3.")
            .otherwise(0.0),
        number("drag_coefficient", "", from(0, 100),
               "C_d; 0.44 is that of a sphere at Reynolds numbers of 1e3 to 2e5 (Clift, Grace and Weber 1978).")
            .in_3d()
            .otherwise(0.44),
        number("drag_coefficient", "", from(0, 100),
               "C_d; 1.1 is that of a cylinder across its axis at Reynolds numbers of 1e3 to 2e5 (Hoerner 1965).")
            .in_2d()
            .otherwise(1.1),
        number("viscosity_Pa_s", "Pa s", from(0, 1e6),
               "Viscosity, for the drag 3 pi mu d v of Stokes; that of air is 1.8e-5 Pa s.")
            .in_3d()
            .otherwise(0.0),
    };
    return table;
}

} // namespace

std::vector<KeyTable> world_tables() {
    return {top_level(), domain(), contact(), box2d(), air()};
}

} // namespace tumble::scene
