#include "scene/key_maker.h"

namespace tumble::scene {
namespace {

KeyTable material() {
    KeyTable table{.path = "material", .head = "[material.NAME]", .repeat = Repeat::named, .required = true};
    table.sentence = "A material, named as pairs, bodies and walls refer to it (letters, digits and _).";
    table.keys = {
        number("density_kg_m3", "kg/m3", above(0, 30000), "Mass of the solid material per volume.").must(),
        number("youngs_modulus_Pa", "Pa", above(0, 1e21),
               "Young's modulus; below 1e6 Pa (rubber) only with `allow_soft = true`.")
            .must(),
        number("poisson_ratio", "", from(0, 0.5), "Poisson's ratio.").must(),
        flag("allow_soft", "True: a Young's modulus below 1e6 Pa is meant; grains will sink into each other."),
    };
    return table;
}

KeyTable pair() {
    KeyTable table{.path = "pair", .head = "[pair.A-B]", .repeat = Repeat::named};
    table.sentence = "What two materials do to each other; also of one with itself, `[pair.media-media]`. Every two "
                     "materials that can meet need one.";
    table.keys = {
        number("restitution", "", from(0, 1), "Speed after a normal impact over the speed before.").must(),
        number("friction", "", from(0, 10), "Coulomb's coefficient of friction.").must(),
        number("normal_stiffness_N_per_m", "N/m", above(0, 1e15), "Spring of `normal = \"linear\"`, required by it."),
        number("tangential_stiffness_N_per_m", "N/m", above(0, 1e15),
               "Spring of `tangential = \"linear\"`, required by it."),
    };
    return table;
}

KeyTable body() {
    KeyTable table{.path = "body", .head = "[body.NAME]", .repeat = Repeat::named};
    table.sentence = "A rigid body: one sphere, or a clump of spheres that may overlap.";
    table.keys = {
        file("clump",
             "Spheres of the body: CSV with the head `x,y,z,radius`, or LIGGGHTS' lines `x y z r`; metres times "
             "`scale`.")
            .one_of("shape"),
        number("radius_m", "m", above(0, 100), "Radius of a body of one sphere.").one_of("shape"),
        number("radius_mm", "mm", above(0, 1e5), "The same in millimetres.").si(1e-3).one_of("shape"),
        KeyMaker("spheres_m", KeyType::rows, "m", above(0, 100), "The spheres written out: [[x, y, z, radius], ...].")
            .one_of("shape"),
        number("scale", "", above(0, 1e6), "Size factor of `clump` and `spheres_m`.").otherwise(1.0),
        text("material", "Name of its material.").must(),
        number("mass_kg", "kg", above(0, 1e6), "Mass; without it density times the volume of the spheres' union."),
        vector("inertia_kg_m2", "kg m2", above(0, 1e9),
               "Moments of inertia about the principal axes that lie nearest to the written x, y and z axes; without "
               "them those of the union."),
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
        vector("region_lo_m", "m", from(-1e4, 1e4), "Lowest corner of the box that bodies lie wholly inside of.")
            .one_of("place"),
        vector("region_hi_m", "m", from(-1e4, 1e4), "Highest corner of that box."),
        vector("position_m", "m", from(-1e4, 1e4), "Centre of mass of a single body, put there exactly (count = 1).")
            .one_of("place"),
        word("orientation", {"random", "as_written"}, "How bodies are turned when they appear.")
            .otherwise(std::string("random")),
        vector("velocity_m_s", "m/s", from(-1e4, 1e4), "Velocity at the start.")
            .otherwise(std::vector<double>{0, 0, 0}),
        vector("angular_velocity_rad_s", "rad/s", from(-1e6, 1e6), "Angular velocity at the start.")
            .otherwise(std::vector<double>{0, 0, 0}),
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
