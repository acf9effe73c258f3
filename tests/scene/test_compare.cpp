#include "scene/compare.h"

#include <doctest/doctest.h>

namespace test_compare {

using namespace tumble;

namespace {

const char* const before = R"(
title = "one"
gravity_m_s2 = [0, -9.81, 0]
seed = 1
[material.glass]
density_kg_m3 = 2500.0
[[wall]]
name = "drum"
opacity = 0.5
[[wall.motion]]
kind = "rotation"
speed_rad_s = 2.0
[[wall]]
name = "lid"
[render]
plot = true
)";

} // namespace

TEST_CASE("scenes are compared key by key, members of lists by their names") {
    const auto same = scene::changes_between(before, before);
    REQUIRE(same.ok());
    CHECK(same->empty());

    const auto changes = scene::changes_between(before, R"(
title = "two"
gravity_m_s2 = [0, -1.62, 0]
[material.glass]
density_kg_m3 = 2500.0
[[wall]]
name = "lid"
opacity = 0.1
[[wall]]
name = "drum"
opacity = 0.5
[[wall.motion]]
kind = "rotation"
speed_rad_s = 3.0
[render]
plot = true
)");
    REQUIRE(changes.ok());
    const std::vector<std::vector<std::string>> expected{{"title", "\"one\"", "\"two\""},
                                                         {"gravity_m_s2", "[0, -9.81, 0]", "[0, -1.62, 0]"},
                                                         {"seed", "1", ""},
                                                         {"wall.drum.motion.0.speed_rad_s", "2", "3"},
                                                         {"wall.lid.opacity", "", "0.1"}};
    REQUIRE(changes->size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK(std::vector<std::string>{(*changes)[k].path, (*changes)[k].before, (*changes)[k].now} == expected[k]);
}

TEST_CASE("what is no TOML cannot be compared, and is said to be which of the two") {
    const auto changes = scene::changes_between(before, "title = ");
    REQUIRE_FALSE(changes.ok());
    CHECK(changes.problems()[0].file == "the scene now");
}

} // namespace test_compare
