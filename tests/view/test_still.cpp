#include "../folder.h"
#include "../run/scenes.h"
#include "run/run_scene.h"
#include "view/live_source.h"
#include "view/recorded_source.h"
#include "view/still.h"

#include <atomic>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <thread>

using namespace tumble;
using namespace tumble::view;

namespace test_still {

constexpr int panel = 300; // pixels

/// Of a simulation at rest at its beginning; 2000 steps of 20 us.
struct Live {
    test::Folder folder;
    SceneText text{test::pouring, "shaken.toml", {}};
    scene::Scene scene = *text.load();
    std::unique_ptr<Studio> studio;

    Live() {
        auto source = open_live(text, scene, 1, [] {});
        REQUIRE(source.ok());
        Plots plots = Plots::of_simulation(scene, *(*source)->layout());
        auto opened = Studio::open(std::move(*source), text, scene, std::move(plots), {1000, 500, folder.path});
        REQUIRE_MESSAGE(opened.ok(), to_string(opened.problems()));
        studio = std::move(*opened);
    }
    StillWishes until(double time) const { return {.to = time, .step = scene.step(), .every = scene.render.every}; }
};

render::Picture taken(Studio& studio, const StillWishes& wishes) {
    auto picture = take_still(studio, wishes, nullptr);
    REQUIRE_MESSAGE(picture.ok(), to_string(picture.problems()));
    return std::move(*picture);
}

bool equal(const render::Picture& a, const render::Picture& b, int left, int right) {
    for (int y = 0; y < a.height; ++y)
        for (int at = 4 * (y * a.width + left); at < 4 * (y * a.width + right); ++at)
            if (a.rgba[static_cast<std::size_t>(at)] != b.rgba[static_cast<std::size_t>(at)])
                return false;
    return true;
}

TEST_CASE("a still of a simulation is what its watchers would see at that step, smooth and twice the same") {
    Live live, again, hand;
    const render::Picture picture = taken(*live.studio, live.until(0.002)); // 100 steps
    CHECK(picture.width == 1000);
    CHECK(live.studio->source().newest()->frame.step == 100);
    CHECK(taken(*again.studio, again.until(0.002)).rgba == picture.rgba);
    REQUIRE(hand.studio->draw().ok());
    hand.studio->source().step(100);
    while (hand.studio->source().newest()->frame.step < 100)
        std::this_thread::yield();
    nlohmann::json state;
    render::Picture seen;
    do {
        auto shown = hand.studio->draw();
        REQUIRE(shown.ok());
        state = nlohmann::json::parse(shown->state);
        seen = std::move(shown->picture);
    } while (state["sketched"] == true);
    CHECK(seen.rgba == picture.rgba);
}

TEST_CASE("a still opens the tab that is asked for, and the scene beside it stays as it is") {
    Live plots, look, none;
    const render::Picture first = taken(*plots.studio, plots.until(0.001));
    StillWishes wishes = look.until(0.001);
    wishes.tab = "Look";
    const render::Picture other = taken(*look.studio, wishes);
    CHECK(!equal(first, other, 0, panel));
    CHECK(equal(first, other, panel, 1000));
    wishes.tab = "Lock";
    const auto missing = take_still(*none.studio, wishes, nullptr);
    REQUIRE(!missing.ok());
    CHECK(missing.problems()[0].what == "the panel shows no tab 'Lock'");
}

/// A ball that fell for 0.02 s, a frame every 5 ms. Its trail is that of the frames from 5 ms on.
TEST_CASE("a still of a run goes through its frames from one time to another, and no further than its end") {
    const test::Folder folder;
    scene::Scene scene = test::loaded(test::falling_ball);
    run::RunOptions options;
    options.folder = folder.path / "run";
    run::RunListener silent;
    REQUIRE(run::run_scene(scene, options, silent).ok());
    const auto text = SceneText::read(options.folder / "scene.toml", {});
    REQUIRE(text.ok());
    scene.render.marks.trails = {"0"};
    const auto still = [&](double from, double to) {
        auto source = open_recorded(options.folder, scene, [] {});
        REQUIRE(source.ok());
        auto studio = Studio::open(std::move(*source), *text, scene, Plots::of_run(options.folder, scene),
                                   {1000, 500, folder.path});
        REQUIRE(studio.ok());
        render::Picture picture = taken(**studio, {.from = from, .to = to});
        return std::pair{std::move(picture), (*studio)->source().newest()->frame.step};
    };
    CHECK(still(0, 0.0101).second == 1500);
    CHECK(still(0, 7).second == 2000);
    const auto one = still(0.015, 0.015), three = still(0.005, 0.015);
    CHECK(one.second == 1500);
    CHECK(three.second == 1500);
    CHECK(!equal(one.first, three.first, panel, 1000)); // its way, and since when
}

TEST_CASE("a still that is stopped is no picture") {
    Live live;
    const std::atomic<bool> stop{true};
    const auto none = take_still(*live.studio, live.until(0.02), &stop);
    REQUIRE(!none.ok());
    CHECK(none.problems()[0].what == "stopped before the picture was drawn");
}

} // namespace test_still
