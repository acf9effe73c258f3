#include "scene/key_maker.h"

#include <numbers>

namespace tumble::scene {
namespace {

KeyTable material() {
    KeyTable table{.path = "material", .head = "[material.NAME]", .repeat = Repeat::named, .required = true};
    table.sentence = "A material, named as pairs, bodies and walls refer to it (letters, digits and _).";
    table.keys = {
        number("density_kg_m3", "kg/m3", above(0, 30000), "Mass of the solid material per volume.").must(),
        number("youngs_modulus_Pa", "Pa", above(0, 1e21),
               "Young's modulus; below 1e6 Pa (rubber) only with `allow_soft = true`.")
            .in_3d()
            .must(),
        number("youngs_modulus_Pa", "Pa", above(0, 1e21),
               "Young's modulus, needed by `normal = \"hertz\"`; below 1e6 Pa (rubber) only with `allow_soft = true`.")
            .in_2d(),
        number("poisson_ratio", "", from(0, 0.5), "Poisson's ratio.").in_3d().must(),
        number("poisson_ratio", "", from(0, 0.5), "Poisson's ratio, needed by `normal = \"hertz\"`.").in_2d(),
        flag("allow_soft", "True: a Young's modulus below 1e6 Pa is meant; grains will sink into each other."),
    };
    return table;
}

/// What the law of Cundall and Strack takes beside restitution and friction; src/contact/cundall_strack.h.
std::vector<Key> linear_law_of_discs() {
    return {
        number("contact_damping_s", "s", from(0, 1e3),
               "Stiffness-proportional damping in place of `restitution`, beta of Cundall and Strack: each dashpot is "
               "beta times its spring.")
            .in_2d()
            .one_of("damping"),
        number("friction_angle_deg", "deg", from(0, 84), "The angle whose tangent is `friction`.")
            .si(std::numbers::pi / 180)
            .in_2d()
            .one_of("friction"),
        number("cohesion_N", "N", from(0, 1e9), "Shear force that a contact bears without normal force.")
            .in_2d()
            .otherwise(0.0),
        number("normal_stiffness_N_per_m", "N/m", above(0, 1e15),
               "Spring k_n of `normal = \"linear\"`, which needs it or `contact_time_s`.")
            .in_2d(),
        number("contact_time_s", "s", above(0, 1e3),
               "How long a normal impact lasts: k_n follows for each contact from it, `restitution` and the masses.")
            .in_2d(),
        number("tangential_stiffness_N_per_m", "N/m", above(0, 1e15),
               "Spring k_s of `tangential = \"linear\"`, which needs it or `stiffness_ratio`.")
            .in_2d(),
        number("stiffness_ratio", "", above(0, 100), "k_s over k_n.").in_2d(),
    };
}

/// What a pair may add to its plain law, docs/laws.md.
std::vector<Key> additions() {
    return {
        number("rolling_friction", "", from(0, 1),
               "Coefficient of rolling friction mu_r of `rolling`: the torque is at most mu_r R* F_n.")
            .otherwise(0.0),
        number("rolling_damping", "", from(0, 10), "Share of critical damping of the rolling spring of \"epsd\".")
            .otherwise(0.3),
        number("rolling_time_s", "s", from(0, 100),
               "tau of a resistance in proportion to how fast a contact rolls, tau R* F_n w, beside `rolling` or "
               "without it: as if mu_r were tau times the spin w in rad/s.")
            .otherwise(0.0),
        number(
            "restitution_exponent", "", from(0, 1),
            "p of a restitution that falls with the speed of impact: `restitution` (v / `restitution_speed_m_s`)^-p. "
            "1/4 for plastic impacts, about 1/5 for viscoelastic ones; 0: it does not fall.")
            .otherwise(0.0),
        number("restitution_speed_m_s", "m/s", above(0, 1e4), "The speed of impact at which `restitution` holds."),
        number("restitution_most", "", above(0, 1),
               "What a restitution that falls with speed is at most in slow impacts.")
            .otherwise(1.0),
        number("sticking_speed_m_s", "m/s", from(0, 1e4),
               "v_s of surfaces that stick: restitution is sqrt(1 - (v_s / v)^2) times what it would be, and slower "
               "impacts do not come back.")
            .otherwise(0.0),
        number("sliding_friction", "", from(0, 10),
               "What `friction` falls to in fast sliding: mu_k + (`friction` - mu_k) exp(-v / `sliding_speed_m_s`)."),
        number("sliding_speed_m_s", "m/s", above(0, 1e4), "The speed of sliding v_c over which friction falls."),
        number("cohesion_energy_J_m3", "J/m3", from(0, 1e12), "Pull per area of contact, of `adhesion = \"sjkr\"`.")
            .in_3d()
            .otherwise(0.0),
        number("work_of_adhesion_J_m2", "J/m2", from(0, 1e3),
               "Work that parts the surfaces, per area, of `adhesion = \"jkr\"` and `\"dmt\"`.")
            .in_3d()
            .otherwise(0.0),
    };
}

KeyTable pair() {
    KeyTable table{.path = "pair", .head = "[pair.A-B]", .repeat = Repeat::named};
    table.sentence = "What two materials do to each other; also of one with itself, `[pair.media-media]`. Every two "
                     "materials that can meet need one.";
    table.keys = {
        number("restitution", "", from(0, 1), "Speed after a normal impact over the speed before.").in_3d().must(),
        number("restitution", "", from(0, 1), "Speed after a normal impact over the speed before.")
            .in_2d()
            .one_of("damping"),
        number("friction", "", from(0, 10), "Coulomb's coefficient of friction.").in_3d().must(),
        number("friction", "", from(0, 10), "Coulomb's coefficient of friction.").in_2d().one_of("friction"),
        number("normal_stiffness_N_per_m", "N/m", above(0, 1e15), "Spring of `normal = \"linear\"`, required by it.")
            .in_3d(),
        number("tangential_stiffness_N_per_m", "N/m", above(0, 1e15),
               "Spring of `tangential = \"linear\"`, required by it.")
            .in_3d(),
    };
    for (const auto part : {linear_law_of_discs, additions})
        for (const Key& key : part())
            table.keys.push_back(key);
    return table;
}

KeyTable body() {
    KeyTable table{.path = "body", .head = "[body.NAME]", .repeat = Repeat::named};
    table.sentence = "A rigid body: one sphere or disc, or a clump of them that may overlap.";
    table.keys = {
        file("clump",
             "Spheres of the body: CSV with the head `x,y,z,radius`, or LIGGGHTS' lines `x y z r`; metres times "
             "`scale`.")
            .in_3d()
            .one_of("shape"),
        file("clump", "Discs of the body: CSV with the head `x,y,radius`, or lines `x y r`; metres times `scale`.")
            .in_2d()
            .one_of("shape"),
        number("radius_m", "m", above(0, 100), "Radius of a body of one sphere or disc.").one_of("shape"),
        number("radius_mm", "mm", above(0, 1e5), "The same in millimetres.").si(1e-3).one_of("shape"),
        rows("spheres_m", "m", 4, above(0, 100), "The spheres written out: [[x, y, z, radius], ...].")
            .in_3d()
            .one_of("shape"),
        rows("discs_m", "m", 3, above(0, 100), "The discs written out: [[x, y, radius], ...].").in_2d().one_of("shape"),
        number("scale", "", above(0, 1e6), "Size factor of `clump`, `spheres_m` and `discs_m`.").otherwise(1.0),
        text("material", "Name of its material.").must(),
        number("mass_kg", "kg", above(0, 1e6),
               "Mass; without it density times the volume of the union of the spheres or discs."),
        vector("inertia_kg_m2", "kg m2", above(0, 1e9),
               "Moments of inertia about the principal axes that lie nearest to the written x, y and z axes; without "
               "them those of the union.")
            .in_3d(),
        number("inertia_kg_m2", "kg m2", above(0, 1e9),
               "Moment of inertia about the centre of mass, across the plane; without it that of the union.")
            .in_2d(),
        vector("tracer_point_m", "m", from(-100, 100),
               "Where a sensor sits in the body, in the coordinates of its spheres before `scale`; the measure "
               "`tracer:NAME` tells what it feels. Without it the centre of mass.")
            .in_3d(),
        vector("tracer_turned_deg", "deg", from(-180, 180),
               "How far that sensor sits turned from where it should: about the axis along this vector, in the "
               "coordinates of the spheres, by its length. Who reads it does not know of it: `felt_` and `spin_` turn, "
               "and gravity leaks into `summed_v`.")
            .si(std::numbers::pi / 180)
            .in_3d(),
        number(
            "cone_diameter_m", "m", above(0, 100),
            "Diameter of the upright cone on y = 0 that the spheres stand for, before `scale`: `reduce.spheres` fits "
            "fewer to it.")
            .in_3d(),
        number("cone_height_m", "m", above(0, 100), "Height of that cone, before `scale`.").in_3d(),
    };
    return table;
}

KeyTable fill() {
    KeyTable table{.path = "fill", .head = "[[fill]]", .repeat = Repeat::many};
    table.sentence = "Bodies put into the scene, without overlap: at random places of a region, or one at a position.";
    table.keys = {
        text("body", "Name of the body.").must(),
        integer("count", from(1, 100000000), "How many.").one_of("amount"),
        number("mass_kg", "kg", above(0, 1e9), "How much: as many bodies as come nearest to this mass.")
            .one_of("amount"),
        vector("region_lo_m", "m", from(-1e4, 1e4),
               "Lowest corner of the box that bodies lie wholly inside of; in two dimensions also on one side of each "
               "closed "
               "wall, that on which most of the box lies.")
            .one_of("place"),
        vector("region_hi_m", "m", from(-1e4, 1e4), "Highest corner of that box."),
        vector("position_m", "m", from(-1e4, 1e4), "Centre of mass of a single body, put there exactly (count = 1).")
            .one_of("place"),
        word("orientation", {"random", "as_written"}, "How bodies are turned when they appear.")
            .otherwise(std::string("random")),
        vector("velocity_m_s", "m/s", from(-1e4, 1e4), "Velocity at the start.")
            .otherwise(std::vector<double>{0, 0, 0}),
        vector("angular_velocity_rad_s", "rad/s", from(-1e6, 1e6), "Angular velocity at the start.")
            .in_3d()
            .otherwise(std::vector<double>{0, 0, 0}),
        number("angular_velocity_rad_s", "rad/s", from(-1e6, 1e6),
               "Angular velocity at the start, counter-clockwise where positive.")
            .in_2d()
            .otherwise(0.0),
        number("start_s", "s", from(0, 1e6), "When bodies begin to appear.").otherwise(0.0),
        number("until_s", "s", from(0, 1e6),
               "When the last try is made; without it all must fit at `start_s`. Each try puts in what fits, the next "
               "goes on."),
        number("every_s", "s", above(0, 1e6), "Time between tries.").otherwise(0.02),
    };
    return table;
}

} // namespace

std::vector<KeyTable> matter_tables() {
    return {material(), pair(), body(), fill()};
}

} // namespace tumble::scene
