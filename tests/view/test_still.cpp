#include "opened.h"
#include "view/still.h"

#include <atomic>

using namespace tumble;
using namespace tumble::view;
using namespace tumble::view::testing;

namespace test_still {

/// Steps of 20 us.
StillWishes until(const Opened& opened, double time) {
    return {.to = time, .step = opened.scene.step(), .every = opened.scene.render.every};
}

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
    Opened live(test::pouring), again(test::pouring), hand(test::pouring);
    const render::Picture picture = taken(*live.studio, until(live, 0.002)); // 100 steps
    CHECK(picture.width == 1000);
    CHECK(live.studio->source().newest()->frame.step == 100);
    CHECK(taken(*again.studio, until(again, 0.002)).rgba == picture.rgba);
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
    Opened plots(test::pouring), look(test::pouring), none(test::pouring);
    const render::Picture first = taken(*plots.studio, until(plots, 0.001));
    StillWishes wishes = until(look, 0.001);
    wishes.tab = "Look";
    const render::Picture other = taken(*look.studio, wishes);
    CHECK(!equal(first, other, 0, panel));
    CHECK(equal(first, other, panel, 1000));
    wishes.tab = "Lock";
    const auto missing = take_still(*none.studio, wishes, nullptr);
    REQUIRE(!missing.ok());
    CHECK(missing.problems()[0].what == "the panel shows no tab 'Lock'");
}

/// A trail is that of the frames that were seen.
TEST_CASE("a still of a run goes through its frames from one time to another, and shows the last of them") {
    Recorded recorded;
    recorded.scene.render.marks.trails = {"0"};
    const auto still = [&](double from, double to) {
        const Opened opened(recorded);
        render::Picture picture = taken(*opened.studio, {.from = from, .to = to});
        return std::pair{std::move(picture), opened.studio->source().newest()->frame.step};
    };
    CHECK(still(0, 0.0149).second == 1000);
    CHECK(still(0, 0.015).second == 1500);
    CHECK(still(0, 7).second == 2000);
    const auto one = still(0.012, 0.015), three = still(0.005, 0.015);
    CHECK(one.second == 1500);
    CHECK(three.second == 1500);
    CHECK(!equal(one.first, three.first, panel, 1000)); // its way, and since when
}

TEST_CASE("a still of a time that is none of a run's or a scene's is refused with those that are") {
    const Recorded recorded;
    const Opened run(recorded), scene(test::pouring);
    const auto refused = [](const Opened& opened, StillWishes wishes) {
        wishes.step = opened.scene.step();
        wishes.every = opened.scene.render.every;
        const auto none = take_still(*opened.studio, wishes, nullptr);
        REQUIRE(!none.ok());
        return none.problems().front().fix;
    };
    CHECK(refused(run, {.from = 0.03, .to = 7}) == "the nearest is at 0.02 s; they go from 0 to 0.02 s");
    CHECK(refused(run, {.to = -1}) == "the nearest is at 0 s; they go from 0 to 0.02 s");
    CHECK(refused(scene, {.from = 0.05, .to = 7}) == "it goes from 0 to 0.04 s");
}

TEST_CASE("a still that is stopped is no picture") {
    Opened live(test::pouring);
    const std::atomic<bool> stop{true};
    const auto none = take_still(*live.studio, until(live, 0.02), &stop);
    REQUIRE(!none.ok());
    CHECK(none.problems()[0].what == "stopped before the picture was drawn");
}

} // namespace test_still
