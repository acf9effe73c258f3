#include "about.h"
#include "reduce/ladder.h"
#include "small_trough.h"

#include <doctest/doctest.h>

namespace test_ladder {

using namespace tumble;
using namespace tumble::reduce;
using tumble::test::about;

namespace {

std::string refusal(const std::string& wish) {
    return to_string(read_wish(wish).problems());
}

} // namespace

TEST_CASE("a ladder has the scene as written, each wish alone, and the wishes together") {
    const auto rungs = ladder(test::small_trough(), {*read_wish("softening=4,16"), *read_wish("size=1.5")});
    REQUIRE_MESSAGE(rungs, to_string(rungs.problems()));
    std::vector<std::string> names;
    for (const Rung& rung : *rungs)
        names.push_back(rung.name);
    CHECK(names ==
          std::vector<std::string>{"as written", "softening 4", "softening 16", "size 1.5", "softening 16, size 1.5"});
    // Springs of 2e5 N/m; discs are lighter by size^2 and step as much longer as sqrt(m / k).
    CHECK((*rungs)[4].scene.pair(0, 0).normal_stiffness == about(2e5 / 16, 1e-12));
    CHECK((*rungs)[4].scene.time_step == about(3e-5 * 4 * 1.5, 1e-12));
    CHECK(*(*rungs)[4].scene.fills[0].count == 11); // 25 / 2.25
}

TEST_CASE("degrees come on top of what the scene is reduced by already") {
    SceneText text = test::small_trough();
    text.sets.emplace_back();
    text.sets.back().text = "reduce.softening=2";
    const auto rungs = ladder(text, {*read_wish("softening=4")});
    REQUIRE_MESSAGE(rungs, to_string(rungs.problems()));
    CHECK((*rungs)[0].scene.pair(0, 0).normal_stiffness == about(1e5, 1e-12));
    CHECK((*rungs)[1].scene.pair(0, 0).normal_stiffness == about(2e5 / 8, 1e-12));
}

TEST_CASE("without wishes a scene gets those that it takes") {
    const auto words = [](const char* scene) {
        std::string all;
        for (const Wish& wish : wishes_for(*SceneText{TUMBLE_ROOT "/scenes/" + std::string(scene), {}}.load()))
            all += std::string(wish.kind->word) + " ";
        return all;
    };
    CHECK(words("trough-quick.toml") == "softening spheres slice size ");
    CHECK(words("bowl-quick.toml") == "softening spheres size ");
    CHECK(words("trough-2d.toml") == "softening size ");
}

TEST_CASE("fewer spheres are a share of those that the body has") {
    const auto rungs = ladder({TUMBLE_ROOT "/scenes/trough-quick.toml", {}}, {*read_wish("spheres=0.3")});
    REQUIRE_MESSAGE(rungs, to_string(rungs.problems()));
    CHECK((*rungs)[1].scene.bodies[0].spheres.size() == 20); // 0.3 * 65 = 19.5
}

TEST_CASE("a rung reduces another when it goes as far in every direction") {
    CHECK(Degrees{.softening = 4, .slice = 0.5}.reduces({.softening = 4}));
    CHECK(Degrees{.softening = 4, .slice = 0.5}.reduces({}));
    CHECK_FALSE(Degrees{.softening = 4}.reduces({.softening = 8}));
    CHECK_FALSE(Degrees{.softening = 4}.reduces({.slice = 0.5}));
}

TEST_CASE("wishes that cannot be are refused") {
    CHECK(refusal("softning=4") == "there is no reduction 'softning'\n    did you mean 'softening'?\n");
    CHECK(refusal("softening=0.5") ==
          "'0.5' is no degree of softening\n    give factors above 1 (stiffnesses divided by it): softening=2,4\n");
    CHECK(refusal("slice=2") ==
          "'2' is no degree of slice\n    give shares above 0 and below 1 (share of the periodic length): slice=0.5\n");
    CHECK(refusal("size=").find("'' is no degree of size") != std::string::npos);
    CHECK(refusal("spheres=32") == "'32' is no degree of spheres\n    give shares above 0 and below 1 (share of each "
                                   "body's spheres, fitted anew to its cone): spheres=0.5\n");
}

TEST_CASE("a share of spheres that leaves too few for a cone is told with the least that does not") {
    const auto refused = [](const char* scene, const std::string& wish) {
        return to_string(ladder({TUMBLE_ROOT "/scenes/" + std::string(scene), {}}, {*read_wish(wish)}).problems());
    };
    // Of 65 spheres 8 are 12.3 %; a tenth are 6.5, which is 7.
    CHECK(
        refused("trough-quick.toml", "spheres=0.1") ==
        "--try spheres=0.1: that share of the 65 spheres of a body is 7, and a cone needs 8\n    give shares from 0.13 "
        "on and below 1, the share of each body's spheres\n");
    CHECK(refused("trough-quick.toml", "spheres=0.13").empty());
    CHECK(refused("drop.toml", "spheres=0.5").starts_with("--try spheres: no body says which cone"));
}

} // namespace test_ladder
