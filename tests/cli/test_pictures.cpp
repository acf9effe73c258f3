#include "process.h"

#include <nlohmann/json.hpp>

namespace test_pictures {

using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// One disc on a floor, quick to run for a second.
const std::string lying_disc = R"(
title = "A disc"
claim = "none"
dimension = 2
depth_m = 0.01
duration_s = 0.1
time_step_s = 1e-4
[domain]
lo_m = [-0.1, -0.1]
hi_m = [0.1, 0.1]
[material.glass]
density_kg_m3 = 2500
[pair.glass-glass]
restitution = 0.5
friction = 0.4
normal_stiffness_N_per_m = 1e3
stiffness_ratio = 0.7
[body.disc]
radius_mm = 10
material = "glass"
[[fill]]
body = "disc"
count = 1
position_m = [0.0, 0.02]
[[wall]]
name = "floor"
shape = "segment"
from_m = [-0.09, 0.0]
to_m = [0.09, 0.0]
material = "glass"
)";

} // namespace

TEST_CASE("render puts instants or sections into one picture, and says what does not go with that") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", "a", "--quiet", "--set", "render.every_s=0.005"}).code ==
            0);
    const Outcome strip = tumble_in(folder, {"render", "a", "--strip", "2x2", "--size", "640x480", "--quiet"});
    CHECK_MESSAGE(strip.code == 0, strip.err);
    CHECK(fs::exists(folder.path / "a/redrawn/front_speed_strip_4.png"));
    const Outcome sections = tumble_in(folder, {"render", "a", "--sections", "2", "--camera", "side", "--size-mm",
                                                "85x60", "--out", "cuts", "--quiet"});
    CHECK_MESSAGE(sections.code == 0, sections.err);
    CHECK(fs::exists(folder.path / "cuts/section_2.png"));
    for (const auto& [flags, words] :
         {std::pair{std::vector<std::string>{"--strip", "six"}, "write --strip 6"},
          {{"--strip", "3", "--sections", "3"}, "leave one of them away"},
          {{"--strip", "3", "--video", "a.mp4"}, "leave --beside, --video and --frames away"},
          {{"--sections", "0"}, "--sections"},
          {{"--strip", "90"}, "ask for fewer"},
          {{"--size-mm", "85x60", "--size", "640x480"}, "write width_mm, height_mm and dpi in its place"},
          {{"--force-chains"}, "write contacts = true in [observe]"}}) {
        std::vector<std::string> all{"render", "a"};
        all.insert(all.end(), flags.begin(), flags.end());
        const Outcome refused = tumble_in(folder, all);
        CAPTURE(words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
    }
    CHECK(tumble_in(folder, {"render", "ball.toml", "--strip", "2"}).code == 2);
}

TEST_CASE(
    "render draws a run of two dimensions as lines where the name ends in .svg or .pdf, and says where it cannot") {
    const Folder folder;
    put(folder.path / "disc.toml", lying_disc);
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    for (const char* scene : {"disc", "ball"})
        REQUIRE(tumble_in(folder, {"run", std::string(scene) + ".toml", "--out", scene, "--quiet"}).code == 0);
    const Outcome svg = tumble_in(folder, {"render", "disc", "--size-mm", "85x60", "--out", "a.svg"});
    CHECK_MESSAGE(svg.code == 0, svg.err);
    CHECK(contains(svg.out, "a.svg: 1 picture from t = "));
    CHECK(contains(content_of(folder.path / "a.svg"), "width=\"85mm\" height=\"60mm\""));
    const Outcome pdf = tumble_in(folder, {"render", "disc", "--out", "new/a.pdf", "--json"});
    CHECK_MESSAGE(pdf.code == 0, pdf.err);
    CHECK(nlohmann::json::parse(pdf.out)["pictures"] == "new/a.pdf");
    for (const auto& [flags, words] :
         {std::pair{std::vector<std::string>{"disc", "--out", "a.svg"}, "--force replaces it"},
          {{"disc", "--out", "b.svg", "--video", "b.mp4"}, "leave --video and --frames away"},
          {{"ball", "--out", "b.svg"}, "SVG and PDF are for scenes in two dimensions"},
          {{"disc.toml", "--out", "b.pdf"}, "run it first"}}) {
        std::vector<std::string> all{"render"};
        all.insert(all.end(), flags.begin(), flags.end());
        const Outcome refused = tumble_in(folder, all);
        CAPTURE(words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
        CHECK(!fs::exists(folder.path / "b.svg"));
    }
}

TEST_CASE("the gallery makes what it can, names what failed, and leaves no runs behind") {
    const Folder folder;
    fs::create_directory(folder.path / "scenes");
    put(folder.path / "scenes/drum-2d.toml", lying_disc); // and no other scene
    const Outcome made = tumble_in(folder, {"gallery", "--out", "pictures", "arrows.png", "sections.png"});
    CHECK(made.code == 1);
    CHECK_MESSAGE(contains(made.out, "1 picture in pictures; failed: sections.png"), (made.out + made.err));
    CHECK(contains(made.err, "arrows.png: done after"));
    CHECK(fs::exists(folder.path / "pictures/arrows.png"));
    CHECK(!fs::exists(folder.path / "pictures/.runs"));
    CHECK(tumble_in(folder, {"gallery", "--out", "pictures", "nothing.png"}).code == 2);
    CHECK(contains(tumble_in(folder, {"gallery"}).err, "write --out docs/gallery"));
}

TEST_CASE("docs/gallery.md shows each picture of the gallery with the two commands that make it") {
    const Folder folder;
    const Outcome listed = tumble_in(folder, {"gallery", "--list", "--json"});
    REQUIRE(listed.code == 0);
    const std::string page = content_of(fs::path(TUMBLE_ROOT) / "docs/gallery.md");
    const auto pictures = nlohmann::json::parse(listed.out);
    CHECK(pictures.size() >= 8);
    for (const auto& picture : pictures) {
        const std::string file = picture["file"];
        CAPTURE(file);
        CHECK(contains(page, "](gallery/" + file + ")"));
        CHECK(contains(page, "tumble " + picture["run"].get<std::string>() + "\n"));
        CHECK(contains(page, "tumble " + picture["render"].get<std::string>() + "\n"));
        const fs::path made = fs::path(TUMBLE_ROOT) / "docs/gallery" / file;
        REQUIRE(fs::exists(made));
        CHECK(fs::file_size(made) < 300000);
    }
}

} // namespace test_pictures
