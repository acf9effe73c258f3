#include "scene/load.h"

#include <doctest/doctest.h>

namespace test_override {

using namespace tumble;
using namespace tumble::scene;

namespace {

const std::filesystem::path slice = TUMBLE_ROOT "/scenes/trough-slice.toml";

std::string refusal(const std::string& set) {
    return to_string(load_scene(slice, {{set}}).problems());
}

} // namespace

TEST_CASE("a set reaches plain keys, members of lists by number and walls by name") {
    const auto scene = load_scene(slice, {{"duration_s=2"},
                                          {"fill.0.count = 10"},
                                          {"gravity_m_s2.1=-1.62"},
                                          {"wall.trough.motion.0.start_s=0.5"},
                                          {"wall.0.opacity=0.5"},
                                          {"contact.limit_force=true"},
                                          {"render.color=vy"},
                                          {"pair.media-media.friction=0.3"},
                                          {"observe.measures=[\"kinetic_energy\"]"}});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->duration == 2);
    CHECK(scene->fills.at(0).count == 10);
    CHECK(scene->gravity.y() == -1.62);
    CHECK(scene->walls.at(0).motion.harmonics.at(0).active.start == 0.5);
    CHECK(scene->walls[0].opacity == 0.5);
    CHECK(scene->contact.limit_force); // a table that the file does not have
    CHECK(scene->render.color == "vy");
    CHECK(scene->pair(0, 0).friction == 0.3);
    CHECK(scene->observe.measures == std::vector<std::string>{"kinetic_energy"});
}

TEST_CASE("a set that changes the colour takes the file's range away, unless a set brings another") {
    const auto range_after = [](const std::vector<Override>& sets) {
        const auto scene = load_scene(TUMBLE_ROOT "/tests/scene/data/rich.toml", sets); // vz, -0.5 to 0.7
        REQUIRE_MESSAGE(scene, to_string(scene.problems()));
        return scene->render.range;
    };
    const std::array<double, 2> of_file{-0.5, 0.7};
    CHECK(range_after({}) == of_file);
    CHECK(range_after({{"render.color=vz"}}) == of_file);
    CHECK(range_after({{"render.color=vy"}}) == std::nullopt);
    CHECK(range_after({{"render.color=vy"}, {"render.color=vz"}}) == of_file);
    CHECK(range_after({{"render.range=[0, 2]"}, {"render.color=vy"}}) == std::array<double, 2>{0, 2});
    CHECK(range_after({{"render.color=vy"}, {"render.range.1=3"}}) == std::array<double, 2>{-0.5, 3});
}

TEST_CASE("a set passes the same checks as the file and is reported under its own name") {
    CHECK(refusal("material.media.densty_kg_m3=1500") ==
          "--set material.media.densty_kg_m3: [material.media] has no key 'densty_kg_m3'\n"
          "    did you mean 'density_kg_m3'?  a number in kg/m3, above 0, at most 30000\n");
    CHECK(refusal("fill.0.count=0") == "--set fill.0.count: 'count' = 0 is out of range\n"
                                       "    write a whole number, 1 to 100000000\n");
    CHECK(refusal("render.camera=frnt") ==
          "--set render.camera: 'camera' cannot be \"frnt\"\n"
          "    did you mean 'front'?  write one of \"front\", \"top\", \"side\", \"free\"\n");
    CHECK(refusal("material.media.youngs_modulus_Pa=1e5") ==
          "--set material.media.youngs_modulus_Pa: 100000 Pa is softer than rubber, grains will sink into each other\n"
          "    write allow_soft = true next to it if that is meant\n");
}

TEST_CASE("a set that leads nowhere says where the way ends") {
    CHECK(refusal("wall.trouhg.opacity=1") == "--set wall.trouhg.opacity: 'wall' has no member 'trouhg'\n"
                                              "    did you mean 'trough'?\n");
    CHECK(refusal("fill.1.count=3") == "--set fill.1.count: 'fill' has no member '1'\n"
                                       "    its members are numbered 0 to 0\n");
    CHECK(refusal("duration_s.x=3") == "--set duration_s.x: 'duration_s' is a number, there is no 'x' in it\n"
                                       "    shorten the key; `tumble list keys` names all of them\n");
    const std::string form = "    write --set KEY=VALUE, for example --set material.media.density_kg_m3=1500\n";
    CHECK(refusal("duration_s") == "--set duration_s: there is no '=' in it\n" + form);
    CHECK(refusal("=3") == "--set: there is no key before '='\n" + form);
    CHECK(refusal("fill..count=3") == "--set fill..count: a part of the key is empty\n" + form);
    CHECK(refusal("gravity_m_s2=[0, -1") == "--set gravity_m_s2: '[0, -1' is not a TOML value\n"
                                            "    check its brackets and quotes\n");
}

TEST_CASE("a key of a table that the scene does not have makes no new table") {
    CHECK(refusal("body.con.material=media") ==
          "--set body.con.material: there is no [body.con]\n"
          "    did you mean 'cone'?  A new one is set as a whole: --set body.con={...}\n");
    CHECK(refusal("material.medai.density_kg_m3=1500") ==
          "--set material.medai.density_kg_m3: there is no [material.medai]\n"
          "    did you mean 'media'?  A new one is set as a whole: --set material.medai={...}\n");
    CHECK(refusal("body.nut.radius_mm=3") ==
          "--set body.nut.radius_mm: there is no [body.nut]\n"
          "    there are cone.  A new one is set as a whole: --set body.nut={...}\n");
    CHECK(refusal("pair.lining-medai.friction=0.1").find("did you mean 'lining-media'?") != std::string::npos);
    const auto scene = load_scene(slice, {{"body.con={radius_mm=3, material=\"media\"}"}});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->bodies.size() == 2);
    // Two materials of the scene make a pair key by key, however near its name is to another's.
    const auto pair = load_scene(slice, {{"material.medib={density_kg_m3=1, youngs_modulus_Pa=1e7, poisson_ratio=0.3}"},
                                         {"pair.media-medib.friction=0.1"},
                                         {"pair.media-medib.restitution=0.5"}});
    REQUIRE_MESSAGE(pair, to_string(pair.problems()));
    CHECK(pair->pair(0, 2).friction == 0.1);
}

TEST_CASE("a set finds a pair in either order of its names") {
    const auto scene = load_scene(slice, {{"pair.lining-media.friction=0.1"}});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->pair(0, 1).friction == 0.1);
    CHECK(scene->pair(0, 1).restitution == load_scene(slice)->pair(0, 1).restitution);
}

TEST_CASE("a set cannot smuggle further keys in") {
    const auto scene = load_scene(slice, {{"title=1\nseed = 3"}});
    REQUIRE(scene); // not a single TOML value, so the whole is text
    CHECK(scene->title == "1\nseed = 3");
    CHECK(scene->seed == 7);
}

TEST_CASE("a later set wins over an earlier one and over the file") {
    const auto scene = load_scene(slice, {{"seed=1"}, {"seed=2"}});
    REQUIRE(scene);
    CHECK(scene->seed == 2);
}

} // namespace test_override
