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
    CHECK(tumble_in(folder, {"render", "a", "--beside", "nowhere"}).code == 2);
    const Outcome scene = tumble_in(folder, {"render", "ball.toml", "--beside", "b"});
    CHECK(scene.code == 2);
    CHECK(contains(scene.err, "run it first"));
    CHECK(!fs::exists(folder.path / "a/redrawn"));
}

} // namespace test_beside
