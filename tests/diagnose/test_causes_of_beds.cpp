#include "about.h"
#include "beds_of_a_formula.h"
#include "scene/to_toml.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_causes_of_beds {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;

namespace {

scene::Scene box() {
    return *scene::load_scene_text(test::shaken_box, "box.toml");
}

scene::Scene with(const std::string& id, double amplitude) {
    scene::Scene scene = box();
    choose_causes({id}, Data::beds)->front().extend(scene, amplitude);
    return scene;
}

} // namespace

TEST_CASE("rocking lifts one side while it lowers the other, in time with the upright shaking") {
    const scene::Scene scene = with("exc.rocking", 0.2);
    const double quarter = 0.25 / 25; // s: the shaking is at its highest
    const scene::WallPose pose = scene::pose_at(scene.walls[0].motion, quarter);
    const double lift = 0.3 * std::sin(0.2 / 57.29577951308232);
    const auto height_at = [&](double x) { return (pose.rotation * Eigen::Vector3d(x, 0, 0) + pose.translation).y(); };
    CHECK(height_at(0.3) == about(0.001 + lift));
    CHECK(height_at(-0.3) == about(0.001 - lift));
}

TEST_CASE("sideways shaking, load and restitution are scaled, and nothing else") {
    CHECK(with("exc.sideways", std::log(2)).walls[0].motion.harmonics[1].amplitude == about(0.002));
    CHECK(with("exc.sideways", 1).walls[0].motion.harmonics[0].amplitude == 0.001);
    CHECK(*with("load.fill", -0.25).fills[0].count == 75);
    CHECK(with("rest.factor", std::log(0.8)).pair(0, 0).restitution == about(0.4));
    CHECK(with("rest.factor", 1).pair(0, 0).restitution == 1);
}

namespace {

/// Sizes of bodies of a scene's fills: how many, and the means of their powers.
struct Sizes {
    double count = 0, mean = 0, square = 0, cube = 0;

    explicit Sizes(const scene::Scene& scene) {
        for (const scene::Fill& fill : scene.fills) {
            const double radius = scene.bodies[static_cast<std::size_t>(fill.body)].spheres[0].radius;
            const auto bodies = static_cast<double>(*fill.count);
            count += bodies, mean += bodies * radius, square += bodies * std::pow(radius, 2);
            cube += bodies * std::pow(radius, 3);
        }
        mean /= count, square /= count, cube /= count;
    }
};

} // namespace

TEST_CASE("sizes are spread in three, with the deviation asked for, the volume of all and steps that the small bear") {
    scene::Scene scene = box();
    scene.fills[0].count = 99; // three times 33
    choose_causes({"size.poly"}, Data::beds)->front().extend(scene, 0.1);
    REQUIRE(scene.fills.size() == 3);
    const Sizes sizes(scene);
    CHECK(sizes.count == 99);
    CHECK(std::sqrt(sizes.square - sizes.mean * sizes.mean) / sizes.mean == about(0.1));
    CHECK(sizes.square == about(0.005 * 0.005)); // discs: as much area as before
    CHECK(scene.time_step == about(1e-5 * (1 - 0.1 * std::sqrt(1.5)) / std::sqrt(1 + 0.1 * 0.1)));
    const auto again = scene::load_scene_text(scene::to_toml(scene), "again.toml");
    REQUIRE(again);
    CHECK(again->bodies.size() == 4); // and what they were made of
    // What three do not divide is of the middle size: one disc of a hundred, smaller by half of one per cent.
    const Sizes hundred(with("size.poly", 0.1));
    CHECK(hundred.count == 100);
    CHECK(hundred.square == about(0.005 * 0.005 * (1 - 0.01 * 0.01 / 1.01)));
    scene = box();
    scene.dimension = 3;
    scene.fills[0].count = 99;
    choose_causes({"size.poly"}, Data::beds)->front().extend(scene, 0.2);
    CHECK(Sizes(scene).cube == about(std::pow(0.005, 3)));
}

TEST_CASE("a mass of bodies keeps its mass when sizes are spread, as many bodies of each size") {
    scene::Scene scene = box();
    scene.fills[0].count.reset();
    scene.fills[0].mass = 2;
    choose_causes({"size.poly"}, Data::beds)->front().extend(scene, 0.2);
    REQUIRE(scene.fills.size() == 3);
    double mass = 0;
    std::vector<double> counts;
    for (const scene::Fill& fill : scene.fills) {
        mass += *fill.mass;
        counts.push_back(*fill.mass / std::pow(scene.bodies[static_cast<std::size_t>(fill.body)].spheres[0].radius, 2));
    }
    CHECK(mass == about(2));
    CHECK(counts[0] == about(counts[1]));
    CHECK(counts[0] == about(counts[2]));
}

TEST_CASE("no spread of sizes is the scene itself, and bodies that are few or placed keep their size") {
    CHECK(scene::to_toml(with("size.poly", 0)) == scene::to_toml(box()));
    scene::Scene scene = box();
    scene::Fill sensor = scene.fills[0];
    sensor.count = 1;
    scene.fills.push_back(sensor);
    sensor.position = Eigen::Vector3d(0, 0.5, 0);
    scene.fills.push_back(sensor);
    choose_causes({"size.poly"}, Data::beds)->front().extend(scene, 0.1);
    REQUIRE(scene.fills.size() == 5);
    CHECK(scene.fills[3].body == 0);
    CHECK(scene.fills[4].body == 0);
    CHECK(scene.bodies[0].spheres[0].radius == 0.005);
    scene.fills = {sensor};
    const std::string alone = scene::to_toml(scene);
    choose_causes({"size.poly"}, Data::beds)->front().extend(scene, 0.1);
    CHECK(scene::to_toml(scene) == alone);
}

TEST_CASE("a second harmonic has twice the frequency and a share of the largest along its axis, and none is none") {
    // 1 mm at 25 Hz along x and y. After 5 ms, an eighth of a period, the second harmonic is at its height.
    const double eighth = 0.125 / 25;
    for (const auto& [id, ahead] : {std::pair("exc.harmonic", 0.0), std::pair("exc.harmonic_ahead", 0.5)}) {
        const scene::Scene scene = with(id, 0.2);
        REQUIRE(scene.walls[0].motion.harmonics.size() == 4);
        for (double t = 0; t < 0.1; t += eighth / 3) {
            const double angle = 2 * std::numbers::pi * 25 * t, more = std::numbers::pi * ahead;
            const double expected = std::sin(angle) + 0.2 * (std::sin(2 * angle + more) - std::sin(more));
            const Eigen::Vector3d place = scene::pose_at(scene.walls[0].motion, t).translation;
            CHECK(std::abs(place.x() - 1e-3 * expected) < 1e-15);
            CHECK(std::abs(place.y() - 1e-3 * expected) < 1e-15);
        }
        CHECK(scene::to_toml(with(id, 0)) == scene::to_toml(box()));
    }
}

TEST_CASE("a frequency drifts by a share of itself in a second") {
    const scene::Scene scene = with("exc.drift", 0.01);
    // 25 Hz for 2 s and 0.25 Hz/s: 50 turns and half a turn.
    for (const double t : {0.7, 1.3, 2.0})
        CHECK(std::abs(scene::pose_at(scene.walls[0].motion, t).translation.y() -
                       1e-3 * std::sin(2 * std::numbers::pi * (25 * t + 0.125 * t * t))) < 1e-14);
    CHECK(scene::to_toml(with("exc.drift", 0)) == scene::to_toml(box()));
    CHECK(scene::load_scene_text(scene::to_toml(scene), "again.toml"));
}

TEST_CASE("longer bodies are two of the same volume together, as long as asked for, and steps are short enough") {
    const double r = 0.005, longer = 0.4;
    for (const int dimension : {2, 3}) {
        scene::Scene scene = box();
        scene.dimension = dimension;
        choose_causes({"shape.clump"}, Data::beds)->front().extend(scene, longer);
        const auto& spheres = scene.bodies[0].spheres;
        REQUIRE(spheres.size() == 2);
        const double thin = spheres[0].radius, d = (spheres[1].centre - spheres[0].centre).norm();
        CHECK(spheres[1].radius == thin);
        CHECK((spheres[0].centre + spheres[1].centre).norm() < 1e-18);
        CHECK((d + 2 * thin) / (2 * thin) == about(1 + longer));
        // Two circles less their lens; two balls less theirs.
        const double half = std::acos(d / (2 * thin));
        const double circles = 2 * std::numbers::pi * thin * thin - thin * thin * (2 * half - std::sin(2 * half));
        const double balls = 8.0 / 3 * std::numbers::pi * std::pow(thin, 3) -
                             std::numbers::pi / 12 * (4 * thin + d) * std::pow(2 * thin - d, 2);
        CHECK((dimension == 2 ? circles : balls) ==
              about(dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3 * std::numbers::pi * r * r * r));
        CHECK(scene.time_step == about(0.5e-5 * thin / r));
    }
    CHECK(scene::to_toml(with("shape.clump", 0)) == scene::to_toml(box()));
    CHECK(scene::load_scene_text(scene::to_toml(with("shape.clump", longer)), "again.toml"));
    scene::Scene sensor = box();
    sensor.fills[0].position = Eigen::Vector3d(0, 0.5, 0);
    choose_causes({"shape.clump"}, Data::beds)->front().extend(sensor, longer);
    CHECK(sensor.bodies[0].spheres.size() == 1); // placed, it stays as it is
}

TEST_CASE("ribs stand higher on bowls and their discs, twelve where there were none, and other walls have none") {
    scene::Scene scene = box();
    scene.walls.push_back(scene.walls[0]);
    scene.walls[0].shape = scene::BowlShape{.ribs = {.count = 8, .height = 0.004, .width = 0.012, .crest = 0.006}};
    scene.walls[1].shape = scene::BowlDiscShape{.ribs = {.count = 0, .height = 0.004, .width = 0.012, .crest = 0.006}};
    const Cause ribs = choose_causes({"wall.ribs"}, Data::beds)->front();
    const auto of = [&](auto* wall) { return std::pair(wall->ribs.count, wall->ribs.height); };
    scene::Scene none = scene;
    ribs.extend(none, 0);
    CHECK(of(std::get_if<scene::BowlDiscShape>(&none.walls[1].shape)) == std::pair(0, 0.004));
    ribs.extend(scene, 2);
    CHECK(of(std::get_if<scene::BowlShape>(&scene.walls[0].shape)) == std::pair(8, 0.006));
    CHECK(of(std::get_if<scene::BowlDiscShape>(&scene.walls[1].shape)) == std::pair(12, 0.002));
    CHECK(scene::to_toml(with("wall.ribs", 2)) == scene::to_toml(box()));
}

TEST_CASE("steps of time are shortened by a share, of either solver, and impacts that stick are stepped five times") {
    scene::Scene scene = box();
    scene.box2d.time_step = 1e-3;
    choose_causes({"num.dt"}, Data::beds)->front().extend(scene, 0.75);
    CHECK(scene.time_step == about(0.25e-5));
    CHECK(scene.box2d.time_step == about(0.25e-3));
    const scene::Scene sticks = with("rest.cutoff", 0.01);
    CHECK(sticks.pair(0, 0).sticking_speed == about(0.1));
    CHECK(sticks.time_step == about(0.2e-5));
    CHECK(with("roll.viscous", 0.01).pair(0, 0).rolling_time == 0.01);
    CHECK(with("shape.multicontact", 0.5).contact.damping_shared == 0); // discs do not
    scene.dimension = 3;
    const Cause shared = choose_causes({"shape.multicontact"}, Data::beds)->front();
    shared.extend(scene, 0.5);
    CHECK(scene.contact.sharing() == 0.5);
    shared.extend(scene, 0.7);
    CHECK(scene.contact.sharing() == 1);
    for (const char* id : {"num.dt", "rest.cutoff", "roll.viscous"})
        CHECK(scene::to_toml(with(id, 0)) == scene::to_toml(box()));
}

TEST_CASE("wall friction acts on walls alone, also where they are of the bodies' material") {
    const scene::Scene scene = with("fric.wall", std::log(3));
    REQUIRE(scene.materials.size() == 2);
    CHECK(scene.walls[0].material == 1);
    CHECK(scene.bodies[0].material == 0);
    CHECK(scene.pair(0, 0).friction == 0.5);
    CHECK(scene.pair(0, 1).friction == about(1.5));
    CHECK(scene.pair(1, 0).friction == about(1.5));
    CHECK(scene::load_scene_text(scene::to_toml(scene), "again.toml")); // it can be written and run
}

TEST_CASE("what beds alone can show is not asked of single bodies, and instruments not of beds") {
    const auto has = [](const std::vector<Cause>& causes, const std::string& id) {
        return std::any_of(causes.begin(), causes.end(), [&](const Cause& cause) { return cause.id == id; });
    };
    const auto records = *choose_causes({}), beds = *choose_causes({}, Data::beds);
    CHECK(!has(records, "load.fill"));
    CHECK(has(records, "ins.gain"));
    CHECK(has(beds, "load.fill"));
    CHECK(!has(beds, "ins.gain"));
    CHECK(has(*choose_causes({"friction"}, Data::beds), "fric.wall"));
    CHECK(!has(*choose_causes({"friction"}), "fric.wall"));
    CHECK(has(*choose_causes({"fric.wall"}), "fric.wall")); // who asks for it gets it
    CHECK(has(records, "ins.align"));
    CHECK(!has(beds, "ins.align"));
    CHECK(!choose_causes({"ins.align"}, Data::beds));
}

} // namespace test_causes_of_beds
