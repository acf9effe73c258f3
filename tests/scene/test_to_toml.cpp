#include "scene/bowl_mesh.h"
#include "scene/keys.h"
#include "scene/load.h"
#include "scene/to_toml.h"

#include <cmath>
#include <doctest/doctest.h>
#include <set>
#include <tuple>

namespace test_to_toml {

using namespace tumble;
using namespace tumble::scene;

namespace {

const std::filesystem::path rich = TUMBLE_ROOT "/tests/scene/data/rich.toml";
const std::filesystem::path flat = TUMBLE_ROOT "/tests/scene/data/rich-2d.toml";

Scene loaded(const Result<Scene>& scene) {
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return *scene;
}

/// Read back from another folder: nothing may depend on where the first file lay.
Scene again(const Scene& scene) {
    return loaded(load_scene_text(to_toml(scene), "/nowhere/resolved.toml"));
}

auto additions_of(const contact::PairProperties& pair) {
    return std::tuple(pair.rolling_friction, pair.rolling_damping, pair.restitution_exponent, pair.restitution_speed,
                      pair.restitution_most, pair.sliding_friction, pair.sliding_speed, pair.rolling_time,
                      pair.sticking_speed);
}

void check_same_motion(const WallMotion& a, const WallMotion& b) {
    REQUIRE(a.harmonics.size() == b.harmonics.size());
    for (std::size_t i = 0; i < a.harmonics.size(); ++i) {
        CHECK(a.harmonics[i].axis == b.harmonics[i].axis);
        CHECK(a.harmonics[i].amplitude == b.harmonics[i].amplitude);
        CHECK(a.harmonics[i].frequency == b.harmonics[i].frequency);
        CHECK(a.harmonics[i].phase == b.harmonics[i].phase);
        CHECK(a.harmonics[i].drift == b.harmonics[i].drift);
        CHECK(a.harmonics[i].active.start == b.harmonics[i].active.start);
        CHECK(a.harmonics[i].active.stop == b.harmonics[i].active.stop);
    }
    REQUIRE(a.rotations.size() == b.rotations.size());
    for (std::size_t i = 0; i < a.rotations.size(); ++i) {
        CHECK(a.rotations[i].axis == b.rotations[i].axis);
        CHECK(a.rotations[i].angular_velocity == b.rotations[i].angular_velocity);
        CHECK(a.rotations[i].centre == b.rotations[i].centre);
    }
    REQUIRE(a.rockings.size() == b.rockings.size());
    for (std::size_t i = 0; i < a.rockings.size(); ++i) {
        CHECK(a.rockings[i].axis == b.rockings[i].axis);
        CHECK(a.rockings[i].amplitude == b.rockings[i].amplitude);
        CHECK(a.rockings[i].phase == b.rockings[i].phase);
        CHECK(a.rockings[i].frequency == b.rockings[i].frequency);
        CHECK(a.rockings[i].drift == b.rockings[i].drift);
    }
    REQUIRE(a.linears.size() == b.linears.size());
    for (std::size_t i = 0; i < a.linears.size(); ++i)
        CHECK(a.linears[i].velocity == b.linears[i].velocity);
    REQUIRE(a.tables.size() == b.tables.size());
    for (std::size_t i = 0; i < a.tables.size(); ++i) {
        CHECK(a.tables[i].time == b.tables[i].time);
        CHECK(a.tables[i].displacement == b.tables[i].displacement);
        CHECK(a.tables[i].active.start == b.tables[i].active.start);
    }
}

} // namespace

TEST_CASE("a resolved scene loads again to the same bodies and fills, bit for bit") {
    const Scene a = loaded(load_scene(rich));
    const Scene b = again(a);
    REQUIRE(a.bodies.size() == b.bodies.size());
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        CHECK(a.bodies[i].name == b.bodies[i].name);
        CHECK(a.bodies[i].material == b.bodies[i].material);
        CHECK(a.bodies[i].mass == b.bodies[i].mass);
        CHECK(a.bodies[i].principal_inertia == b.bodies[i].principal_inertia);
        CHECK(a.bodies[i].tracer_point == b.bodies[i].tracer_point);
        CHECK(a.bodies[i].tracer_turned == b.bodies[i].tracer_turned);
        REQUIRE(a.bodies[i].cone.has_value() == b.bodies[i].cone.has_value());
        CHECK((!a.bodies[i].cone || a.bodies[i].cone->height == b.bodies[i].cone->height));
        REQUIRE(a.bodies[i].spheres.size() == b.bodies[i].spheres.size());
        for (std::size_t k = 0; k < a.bodies[i].spheres.size(); ++k) {
            CHECK(a.bodies[i].spheres[k].centre == b.bodies[i].spheres[k].centre);
            CHECK(a.bodies[i].spheres[k].radius == b.bodies[i].spheres[k].radius);
        }
    }
    REQUIRE(a.fills.size() == b.fills.size());
    for (std::size_t i = 0; i < a.fills.size(); ++i) {
        CHECK(a.fills[i].body == b.fills[i].body);
        CHECK(a.fills[i].count == b.fills[i].count);
        CHECK(a.fills[i].mass == b.fills[i].mass);
        CHECK(a.fills[i].region.lo == b.fills[i].region.lo);
        CHECK(a.fills[i].region.hi == b.fills[i].region.hi);
        CHECK(a.fills[i].orientation == b.fills[i].orientation);
        CHECK(a.fills[i].velocity == b.fills[i].velocity);
        CHECK(a.fills[i].angular_velocity == b.fills[i].angular_velocity);
        CHECK(std::tuple(a.fills[i].start, a.fills[i].until, a.fills[i].every) ==
              std::tuple(b.fills[i].start, b.fills[i].until, b.fills[i].every));
        CHECK(a.fills[i].position == b.fills[i].position);
    }
}

TEST_CASE("a resolved scene loads again to the same walls and motions, bit for bit") {
    const Scene a = loaded(load_scene(rich));
    const Scene b = again(a);
    REQUIRE(a.walls.size() == b.walls.size());
    for (std::size_t i = 0; i < a.walls.size(); ++i) {
        CAPTURE(a.walls[i].name);
        CHECK(a.walls[i].name == b.walls[i].name);
        CHECK(a.walls[i].material == b.walls[i].material);
        CHECK(a.walls[i].opacity == b.walls[i].opacity);
        CHECK(a.walls[i].shape.index() == b.walls[i].shape.index());
        check_same_motion(a.walls[i].motion, b.walls[i].motion);
    }
    CHECK(std::get<PlaneShape>(a.walls[0].shape).normal == std::get<PlaneShape>(b.walls[0].shape).normal);
    CHECK(std::get<BoxShape>(a.walls[1].shape).open == std::get<BoxShape>(b.walls[1].shape).open);
    CHECK(std::get<CylinderShape>(a.walls[2].shape).axis == std::get<CylinderShape>(b.walls[2].shape).axis);
    CHECK(std::get<DiscShape>(a.walls[3].shape).normal == std::get<DiscShape>(b.walls[3].shape).normal);
    CHECK(std::get<TroughShape>(a.walls[4].shape).flare == std::get<TroughShape>(b.walls[4].shape).flare);
    CHECK(std::get<MeshShape>(a.walls[5].shape).triangles == std::get<MeshShape>(b.walls[5].shape).triangles);
    const auto &bowl = std::get<BowlShape>(a.walls[6].shape), &bowl_again = std::get<BowlShape>(b.walls[6].shape);
    CHECK(mesh_of(bowl).triangles == mesh_of(bowl_again).triangles);
    const auto &disc = std::get<BowlDiscShape>(a.walls[7].shape),
               &disc_again = std::get<BowlDiscShape>(b.walls[7].shape);
    CHECK(mesh_of(disc).triangles == mesh_of(disc_again).triangles);
    for (const std::size_t specimen : {8, 9, 10}) {
        const auto &part = std::get<SpecimenShape>(a.walls[specimen].shape),
                   &part_again = std::get<SpecimenShape>(b.walls[specimen].shape);
        CHECK(part.mesh->nodes == part_again.mesh->nodes);
        CHECK(part.mesh->hexes == part_again.mesh->hexes);
        CHECK(part.held == part_again.held);
        CHECK(part.held_set == part_again.held_set);
        CHECK(part.youngs_modulus == part_again.youngs_modulus);
        CHECK(part.poisson_ratio == part_again.poisson_ratio);
    }
    CHECK(a.render.clip->lo == b.render.clip->lo);
    CHECK(a.render.clip->hi == b.render.clip->hi);
    CHECK(a.render.clip_cuts);
    CHECK(b.render.clip_cuts);
    CHECK(a.render.turn_deg_s == 90);
    CHECK(b.render.turn_deg_s == 90);
    CHECK(b.observe.contacts);
    CHECK(b.observe.axes_turned == a.observe.axes_turned);
    CHECK(std::abs(b.observe.axes_turned * 57.29577951308232 - 1.7) < 1e-12);
    CHECK(a.render.marks.arrow_speed == 0.3);
    CHECK(a.render.marks == b.render.marks);
}

TEST_CASE("a resolved scene loads again to the same laws, materials and pairs") {
    const Scene a = loaded(load_scene(rich));
    const Scene b = again(a);
    CHECK(std::tuple(a.title, a.claim, a.duration, a.time_step, a.seed, a.allow_large_step, a.skin) ==
          std::tuple(b.title, b.claim, b.duration, b.time_step, b.seed, b.allow_large_step, b.skin));
    CHECK(a.gravity == b.gravity);
    CHECK(a.domain.box.hi == b.domain.box.hi);
    CHECK(a.domain.periodic == b.domain.periodic);
    CHECK(std::tuple(a.contact.normal, a.contact.tangential, a.contact.limit_force,
                     a.contact.share_among_body_contacts) == std::tuple(b.contact.normal, b.contact.tangential,
                                                                        b.contact.limit_force,
                                                                        b.contact.share_among_body_contacts));
    CHECK(b.contact.damping_shared == 0.25);
    Scene all_shared = a;
    all_shared.contact.damping_shared = 0;
    all_shared.contact.share_among_body_contacts = true;
    CHECK(again(all_shared).contact.share_among_body_contacts);
    CHECK(b.contact.additions.rolling == contact::RollingLaw::epsd);
    CHECK(b.contact.additions.adhesion == contact::AdhesionLaw::sjkr);
    CHECK(b.pairs[1].cohesion_energy == 1234.5);
    CHECK(std::tuple(b.air.density, b.air.drag_coefficient, b.air.viscosity) == std::tuple(1.3, 0.5, 1.7e-5));
    CHECK(a.contact.accepted_overlap == 0.123);
    CHECK(b.contact.accepted_overlap == 0.123);
    REQUIRE(a.materials.size() == b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i)
        CHECK(std::tuple(a.materials[i].name, a.materials[i].density, a.materials[i].youngs_modulus,
                         a.materials[i].poisson_ratio) == std::tuple(b.materials[i].name, b.materials[i].density,
                                                                     b.materials[i].youngs_modulus,
                                                                     b.materials[i].poisson_ratio));
    REQUIRE(a.pairs.size() == b.pairs.size());
    for (std::size_t i = 0; i < a.pairs.size(); ++i) {
        CHECK(additions_of(a.pairs[i]) == additions_of(b.pairs[i]));
        CHECK(std::tuple(a.pairs[i].restitution, a.pairs[i].friction, a.pairs[i].normal_stiffness,
                         a.pairs[i].tangential_stiffness) == std::tuple(b.pairs[i].restitution, b.pairs[i].friction,
                                                                        b.pairs[i].normal_stiffness,
                                                                        b.pairs[i].tangential_stiffness));
    }
    CHECK(additions_of(a.pairs[1]) == std::tuple(0.07, 0.4, 0.25, 0.9, 0.8, 0.6, 0.05, 0.003, 0.02));
}

TEST_CASE("what is written once is written the same again") {
    const std::string once = to_toml(loaded(load_scene(rich)));
    CHECK(to_toml(again(loaded(load_scene(rich)))) == once);
    CHECK(to_toml(again(loaded(load_scene(flat)))) == to_toml(loaded(load_scene(flat))));
    for (const char* name : {"drop", "oblique", "settle-cones", "trough-slice", "trough-quick", "trough-2d", "bowl",
                             "bowl-quick", "bowl-spheres", "repose-2d", "hopper-2d", "drum-2d", "shaken-bed-2d"}) {
        CAPTURE(name);
        const Scene scene =
            loaded(load_scene(std::filesystem::path(TUMBLE_ROOT "/scenes") / (std::string(name) + ".toml")));
        CHECK(to_toml(again(scene)) == to_toml(scene));
    }
}

TEST_CASE("[box2d] is written of scenes that it solves, and loads again; of others, which do not read it, it is not") {
    const std::filesystem::path drum = TUMBLE_ROOT "/scenes/drum-2d.toml";
    CHECK(to_toml(loaded(load_scene(flat))).find("box2d") == std::string::npos);
    CHECK(to_toml(loaded(load_scene(drum))).find("box2d") == std::string::npos);
    const Scene a = loaded(load_scene(drum, {{"solver=\"box2d\""},
                                             {"box2d.time_step_s=0.0005"},
                                             {"box2d.velocity_iterations=11"},
                                             {"box2d.position_iterations=7"},
                                             {"box2d.rebound_above_m_s=0.013"}}));
    const Scene b = again(a);
    CHECK(b.solver == Solver::box2d);
    CHECK(std::tuple(b.box2d.time_step, b.box2d.velocity_iterations, b.box2d.position_iterations,
                     b.box2d.rebound_above) == std::tuple(0.0005, 11, 7, 0.013));
    CHECK(to_toml(b) == to_toml(a));
}

TEST_CASE("a resolved scene says what it left to the defaults, so that it means the same where they are others") {
    const std::string toml = to_toml(loaded(load_scene(TUMBLE_ROOT "/scenes/drop.toml")));
    for (const char* line : {"\nallow_large_step = false\n", "\ntangential = \"mindlin\"\n", "\nplot = true\n",
                             "\ncolormap = \"auto\"\n", "\nopacity = 0.25\n"})
        CHECK_MESSAGE(toml.find(line) != std::string::npos, line << " in\n" << toml);
}

TEST_CASE("meshes that were copied beside the scene go by the names they have there") {
    const Scene scene = loaded(load_scene(rich));
    const std::filesystem::path file = std::get<MeshShape>(scene.walls.at(5).shape).file;
    CHECK(to_toml(scene).find("stl = \"" + std::filesystem::absolute(file).string() + "\"") != std::string::npos);
    CHECK(to_toml(scene, {{file, "meshes/a.stl"}}).find("stl = \"meshes/a.stl\"") != std::string::npos);
}

TEST_CASE("every key of the list arrives in the scene and is written again") {
    // Other ways to say what is written as spheres_m, discs_m, rows, harmonic, friction or cohesion energy; three
    // dimensions are usual; of [reduce] what came of it is written.
    std::set<std::string> other_ways{"clump", "radius_mm", "file", "amplitude_factor", "frequency_factor", "speed_rpm",
                                     "friction_angle_deg", "work_of_adhesion_J_m2", "dimension",
                                     // of a picture for print; a screen's has its size in pixels
                                     "width_mm", "height_mm", "dpi", "font_pt"};
    for (const int dimension : {3, 2}) {
        if (dimension == 2) // discs have no mesh to scale
            other_ways.insert("scale");
        Scene scene = loaded(load_scene(dimension == 3 ? rich : flat));
        std::string toml = "\n" + to_toml(scene);
        if (dimension == 2) { // the keys of hard contacts are written where they are read
            scene.solver = Solver::box2d;
            toml += to_toml(scene);
        }
        for (const KeyTable& table : scene_keys())
            for (const Key& key : table.keys) {
                CAPTURE(table.path);
                CAPTURE(key.name);
                if (belongs_in(key, dimension) && !other_ways.count(key.name) && table.path != "reduce")
                    CHECK(toml.find("\n" + key.name + " = ") != std::string::npos);
            }
    }
}

TEST_CASE("a resolved scene of two dimensions loads again to the same bodies, pairs and walls, bit for bit") {
    const Scene a = loaded(load_scene(flat));
    const Scene b = again(a);
    CHECK(a.depth == 0.07);
    CHECK(a.domain.box.lo == b.domain.box.lo);
    CHECK(a.contact.global_damping == b.contact.global_damping);
    for (std::size_t i = 0; i < a.pairs.size(); ++i) {
        CHECK(additions_of(a.pairs[i]) == additions_of(b.pairs[i]));
        CHECK(std::tuple(a.pairs[i].restitution, a.pairs[i].friction, a.pairs[i].contact_time,
                         a.pairs[i].stiffness_ratio, a.pairs[i].damping_time, a.pairs[i].cohesion) ==
              std::tuple(b.pairs[i].restitution, b.pairs[i].friction, b.pairs[i].contact_time,
                         b.pairs[i].stiffness_ratio, b.pairs[i].damping_time, b.pairs[i].cohesion));
    }
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        CHECK(a.bodies[i].principal_inertia == b.bodies[i].principal_inertia);
        REQUIRE(a.bodies[i].spheres.size() == b.bodies[i].spheres.size());
        for (std::size_t k = 0; k < a.bodies[i].spheres.size(); ++k)
            CHECK(a.bodies[i].spheres[k].centre == b.bodies[i].spheres[k].centre);
    }
    for (std::size_t i = 0; i < a.fills.size(); ++i)
        CHECK(a.fills[i].angular_velocity == b.fills[i].angular_velocity);
    for (std::size_t i = 0; i < a.walls.size(); ++i) {
        REQUIRE(a.walls[i].outline.index() == b.walls[i].outline.index());
        check_same_motion(a.walls[i].motion, b.walls[i].motion);
    }
    CHECK(std::get<ArcShape>(a.walls[2].outline).sweep == std::get<ArcShape>(b.walls[2].outline).sweep);
    CHECK(std::get<PolylineShape>(a.walls[3].outline).points == std::get<PolylineShape>(b.walls[3].outline).points);
}

TEST_CASE("a picture for print is written in mm, dpi and points, and is the same when it is read again") {
    const Scene a =
        loaded(load_scene(rich, {{"render.style=\"paper\""}, {"render.width_mm=120.5"}, {"render.dpi=250"}}));
    const Scene b = again(a);
    REQUIRE(b.render.paper);
    CHECK(b.render.paper->width_mm == 120.5);
    CHECK(b.render.paper->dpi == 250);
    CHECK(b.render.width == 1186); // 120.5 / 25.4 * 250
    CHECK(to_toml(b) == to_toml(a));
}

} // namespace test_to_toml
