#include "about.h"
#include "beds_of_a_formula.h"
#include "scene/to_toml.h"

#include <doctest/doctest.h>

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
}

} // namespace test_causes_of_beds
