#include "folder.h"
#include "run/scene_check.h"
#include "run/scene_doubts.h"
#include "run/scenes.h"
#include "solid/generate.h"
#include "solid/inp.h"

namespace test_scene_doubts {

using namespace tumble;
using namespace tumble::test;

namespace {

/// What is doubtful about the falling ball with these keys; all in one text.
std::string doubts(const std::vector<std::string>& sets) {
    const auto check = run::check_scene(loaded(falling_ball, sets), 1);
    REQUIRE_MESSAGE(check.ok(), to_string(check.problems()));
    std::string text;
    for (const std::string& warning : check->warnings)
        text += warning + "\n";
    return text;
}

} // namespace

TEST_CASE("a scene in its right units raises no doubt") {
    CHECK(doubts({}).empty());
}

TEST_CASE("a density in g/cm3 is doubted with the value it would be") {
    CHECK(doubts({"material.glass.density_kg_m3=2.5", "time_step_s=1e-7"}) ==
          "--set material.glass.density_kg_m3: 2.5 kg/m3 is lighter than plastic foam\n"
          "    if it is 2.5 g/cm3, write 2500\n");
}

TEST_CASE("a mass in grams is doubted by the density it makes") {
    // 10 g in the 4189 mm3 of the ball are 2387 kg/m3.
    CHECK(doubts({"body.ball.mass_kg=0.01"}).empty());
    CHECK(doubts({"body.ball.mass_kg=10"}).find("is 2.39e+06 kg/m3, denser than any solid") != std::string::npos);
}

TEST_CASE("a gravity in cm/s2 is doubted") {
    CHECK(doubts({"gravity_m_s2.1=-981"}).find("981 m/s2 is 100 times the Earth's") != std::string::npos);
}

TEST_CASE("a wall that swings through the whole domain, or faster than any machine, is doubted") {
    const std::string motion = "wall.floor.motion=[{kind=\"harmonic\", axis=\"y\", amplitude_m=";
    CHECK(doubts({motion + "0.003, frequency_Hz=30}]"}).empty());
    CHECK(doubts({motion + "3, frequency_Hz=30}]"}).find("swings by 3 m along y, and the domain is 0.7 m long") !=
          std::string::npos);
    CHECK(doubts({motion + "0.003, frequency_Hz=1800}]"}).find("shaken at up to 33.93 m/s") != std::string::npos);
}

TEST_CASE("a cylinder in millimetres is doubted by its size") {
    CHECK(doubts({"wall.floor={name=\"floor\", shape=\"cylinder\", base_m=[0, -60, 0], length_m=120, radius_m=60, "
                  "material=\"glass\"}"})
              .find("wall 'floor' is 120 m large, 171 times the domain") != std::string::npos);
}

TEST_CASE("a specimen in millimetres is doubted by its size, and one from a file told of its scale") {
    const Folder folder;
    const solid::HexMesh part = *solid::mesh_of(
        solid::Prism{.length = 50, .side = 15, .corner = 5, .corner_cells = 1, .middle_cells = 1, .along = 2}, {});
    put(folder.path / "part.inp", solid::to_inp(part, {2e11, 0.3, "C3D8", {"base"}}, {}));
    const auto with = [&](const std::string& scale) {
        return doubts({"wall.floor={name=\"floor\", shape=\"hexahedra\", inp=\"" + (folder.path / "part.inp").string() +
                       "\", axis=[0, 1, 0], held_set=\"base\", material=\"glass\"" + scale + "}"});
    };
    CHECK(with(", scale=0.001").empty());
    const std::string vast = with("");
    CHECK(vast.find("wall 'floor' is 50 m large, 71.4 times the domain") != std::string::npos);
    CHECK(vast.find("a mesh file in millimetres wants scale = 0.001") != std::string::npos);
}

TEST_CASE("a disc that does not fit into its bowl is doubted, one with a gap of millimetres is not") {
    const auto with = [](const std::string& disc) {
        return doubts({"domain.lo_m=[-0.4, -0.1, -0.4]", "domain.hi_m=[0.4, 0.6, 0.4]",
                       "wall=[{name=\"bowl\", shape=\"bowl\", base_m=[0, 0, 0], radius_m=0.1665, height_m=0.21, "
                       "material=\"glass\"}, {name=\"disc\", shape=\"bowl-disc\", centre_m=[0, 0, 0], "
                       "material=\"glass\", " +
                           disc + "}]"});
    };
    CHECK(with("radius_m=0.1645") == "");
    CHECK(with("radius_m=0.17").find("disc 'disc' reaches through the wall of bowl 'bowl', whose radius is 0.1665 m") !=
          std::string::npos);
    // The ball of 10 mm radius.
    CHECK(with("radius_m=0.14").find("a gap of 26.5 mm, through which bodies of 20 mm fall") != std::string::npos);
    CHECK(with("radius_m=0.1645, rim_rise_m=0.25").find("ends 40 mm above the wall of bowl 'bowl'") !=
          std::string::npos);
}

TEST_CASE("bodies that come after the end are doubted, those that come in time are not") {
    const std::string text = doubts({"fill.0.start_s=5"});
    CHECK(text.find("1 of body 'ball' come at 5 s, but the run ends at 0.02 s") != std::string::npos);
    CHECK(doubts({"fill.0.start_s=0.01"}).empty());
}

} // namespace test_scene_doubts
