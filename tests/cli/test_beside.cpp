#include "process.h"

namespace test_beside {

using namespace tumble::test;
namespace fs = std::filesystem;

TEST_CASE("render --beside draws two runs into one picture, and says what is wrong with either") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    for (const char* name : {"a", "b"})
        REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", name, "--quiet"}).code == 0);
    const Outcome drawn = tumble_in(folder, {"render", "a", "--beside", "b", "--labels", "one,other", "--size",
                                             "640x360", "--out", "both", "--quiet"});
    CHECK_MESSAGE(drawn.code == 0, drawn.err);
    CHECK(fs::exists(folder.path / "both/frame_000000.png"));

    const Outcome one_label = tumble_in(folder, {"render", "a", "--beside", "b", "--labels", "one"});
    CHECK(one_label.code == 2);
    CHECK(contains(one_label.err, "write --labels LEFT,RIGHT"));
    const Outcome labels_of_one = tumble_in(folder, {"render", "a", "--labels", "one,other"});
    CHECK(labels_of_one.code == 2);
    CHECK(contains(labels_of_one.err, "add --beside OTHER"));
    CHECK(tumble_in(folder, {"render", "a", "--beside", "nowhere"}).code == 2);
    const Outcome scene = tumble_in(folder, {"render", "ball.toml", "--beside", "b"});
    CHECK(scene.code == 2);
    CHECK(contains(scene.err, "run it first"));
    CHECK(!fs::exists(folder.path / "a/redrawn"));
}

TEST_CASE("render takes the free camera where an eye or a target is given, and another only where that is asked for") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", "a", "--quiet"}).code == 0);
    const Outcome half = tumble_in(folder, {"render", "a", "--eye", "0.3,0.3,0.3", "--size", "320x180", "--quiet"});
    CHECK(half.code == 2);
    CHECK(contains(half.err, "--eye 0.3,0.3,0.3"));
    CHECK(contains(half.err, "give target_m too"));
    CHECK(contains(half.err, "for example --eye 1,1,0.5 --target 0,0,0"));
    const Outcome eye =
        tumble_in(folder, {"render", "a", "--eye", "0.3,0.3,0.3", "--target", "0,0,0", "--size", "320x180", "--quiet"});
    CHECK_MESSAGE(eye.code == 0, eye.err);
    CHECK(fs::exists(folder.path / "a/redrawn/free_speed"));
    const Outcome side =
        tumble_in(folder, {"render", "a", "--target", "0,0.1,0", "--camera", "side", "--size", "320x180", "--quiet"});
    CHECK_MESSAGE(side.code == 0, side.err);
    CHECK(fs::exists(folder.path / "a/redrawn/side_speed"));
}

} // namespace test_beside
