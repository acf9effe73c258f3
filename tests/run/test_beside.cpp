#include "about.h"
#include "folder.h"
#include "run/beside.h"
#include "run/run_scene.h"
#include "scenes.h"

#include <algorithm>

namespace test_beside {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// Two runs of the falling ball that differ in how long they last and how long their steps are.
struct TwoRuns {
    Folder folder;
    std::array<fs::path, 2> runs{folder.path / "left", folder.path / "right"};

    TwoRuns() {
        leave(loaded(falling_ball), runs[0]);
        leave(loaded(falling_ball, {"duration_s=0.0105", "time_step_s=0.7e-5", "gravity_m_s2=[0, 0, 0]"}), runs[1]);
    }
    static void leave(const scene::Scene& scene, const fs::path& where) {
        run::RunOptions options;
        options.folder = where;
        run::RunListener silent;
        REQUIRE(run::run_scene(scene, options, silent).ok());
    }
};

run::BesideOptions wide(const fs::path& pictures) {
    run::BesideOptions options;
    options.settings = loaded(falling_ball, {"render.width_px=640", "render.height_px=360"}).render;
    options.targets.folder = pictures;
    return options;
}

run::Replayed drawn(const TwoRuns& two, const run::BesideOptions& options) {
    const auto done = run::draw_beside(two.runs, options, [](std::int64_t, std::int64_t) {});
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
    return *done;
}

} // namespace

TEST_CASE("two runs stand side by side at the times that both have, though their steps differ") {
    const TwoRuns two;
    const run::Replayed done = drawn(two, wide(two.folder.path / "both"));
    // Frames at 0, 5 and 10 ms are in both; the left one goes on to 20 ms, the right one ends with one at 10.5 ms.
    CHECK(done.frames == 3);
    CHECK(done.first == 0);
    CHECK(done.last == about(0.01, 1e-3));
    CHECK(count_files(two.folder.path / "both", ".png") == 3);
    const auto told = [&](const std::string& words) {
        return std::any_of(done.warnings.begin(), done.warnings.end(),
                           [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
    };
    CHECK(told("left: 2 of its frames have none beside them"));
    CHECK(told("right: 1 of its frames have none beside them"));
}

TEST_CASE("a run in space and a flat one have no view in common") {
    TwoRuns two;
    two.runs[1] = two.folder.path / "flat";
    TwoRuns::leave(loaded(raining), two.runs[1]);
    const auto done = run::draw_beside(two.runs, wide(two.folder.path / "both"), [](std::int64_t, std::int64_t) {});
    REQUIRE(!done.ok());
    CHECK(done.problems()[0].what.find("no view in common") != std::string::npos);
    CHECK(!fs::exists(two.folder.path / "both"));
}

TEST_CASE("pictures of two runs have the numbers that the left run's frames have") {
    const TwoRuns two;
    run::BesideOptions options = wide(two.folder.path / "both");
    options.when.from = 0.004;
    CHECK(drawn(two, options).frames == 2);
    for (const char* name : {"frame_000001.png", "frame_000002.png"})
        CHECK_MESSAGE(fs::exists(options.targets.folder / name), name);
}

TEST_CASE("what is there is not drawn over without force, and a broken comparison leaves nothing") {
    const TwoRuns two;
    run::BesideOptions options = wide(two.folder.path / "both");
    (void)drawn(two, options);
    const auto again = run::draw_beside(two.runs, options, [](std::int64_t, std::int64_t) {});
    REQUIRE(!again.ok());
    CHECK(again.problems()[0].fix == "--force replaces it; or name another place");
    options.overwrite = true;
    options.when.to = 0.001;
    CHECK(drawn(two, options).frames == 1);
    CHECK(count_files(two.folder.path / "both", ".png") == 1);

    run::BesideOptions small = wide(two.folder.path / "small");
    small.settings.width = 300;
    const auto refused = run::draw_beside(two.runs, small, [](std::int64_t, std::int64_t) {});
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].what == "two runs side by side need a picture of 480 x 240 pixels or more");
    CHECK(!fs::exists(two.folder.path / "small"));
}

} // namespace test_beside
