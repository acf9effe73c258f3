#include "process.h"

namespace test_pictures {

using namespace tumble::test;
namespace fs = std::filesystem;

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

} // namespace test_pictures
