#include "scene/load.h"

#include <doctest/doctest.h>

using namespace tumble;
using namespace tumble::scene;

TEST_CASE("the drop scene loads in SI units with its defaults filled in") {
    const auto scene = load_scene(TUMBLE_ROOT "/scenes/drop.toml");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->bodies.at(0).spheres.at(0).radius == doctest::Approx(0.01275).epsilon(1e-15));
    CHECK(scene->materials.at(0).youngs_modulus == 4.6e8);
    CHECK(scene->pair(0, 0).restitution == 0.67);
    CHECK(scene->gravity.y() == -9.81);
    REQUIRE(scene->fills.at(0).position);
    CHECK(scene->fills[0].position->y() == 0.21275);
    CHECK(scene->fills[0].until == scene->fills[0].start);
    CHECK(std::holds_alternative<PlaneShape>(scene->walls.at(0).shape));
}
