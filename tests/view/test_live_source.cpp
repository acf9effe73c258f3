#include "../about.h"
#include "../run/scenes.h"
#include "run/simulation.h"
#include "scene/to_toml.h"
#include "view/live_source.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <doctest/doctest.h>
#include <functional>
#include <mutex>

using namespace tumble;
using namespace tumble::view;
using test::about;

namespace test_live_source {

/// A source and the news of it.
struct Live {
    std::mutex mutex;
    std::condition_variable changed;
    std::int64_t news = 0;
    SceneText text;
    scene::Scene scene;
    std::unique_ptr<Source> source;

    explicit Live(const std::string& toml, const std::vector<scene::Override>& sets = {})
        : text{toml, "test.toml", sets} {
        auto loaded = text.load();
        REQUIRE_MESSAGE(loaded.ok(), to_string(loaded.problems()));
        scene = std::move(*loaded);
        auto opened = open_live(text, scene, 1, [this] {
            {
                const std::lock_guard lock(mutex);
                ++news;
            }
            changed.notify_all();
        });
        REQUIRE_MESSAGE(opened.ok(), to_string(opened.problems()));
        source = std::move(*opened);
    }

    /// Waits until something holds; a minute is only there so that a broken program fails instead of hanging.
    bool eventually(const std::function<bool()>& holds) {
        std::unique_lock lock(mutex);
        for (int i = 0; i < 6000; ++i) {
            lock.unlock();
            if (holds())
                return true;
            lock.lock();
            changed.wait_for(lock, std::chrono::milliseconds(10));
        }
        return false;
    }
    bool reaches(std::int64_t step) {
        return eventually([&] { return source->newest()->frame.step >= step; });
    }
};

TEST_CASE(
    "a scene that was looked at while it ran ends with the bits of one that nobody saw, in space and in the plane") {
    for (const std::string& toml : {test::pouring, test::raining}) {
        Live live(toml);
        CHECK(live.source->newest()->frame.step == 0);
        live.source->step(7);
        REQUIRE(live.reaches(7));
        CHECK(live.source->newest()->frame.step == 7);
        CHECK(!live.source->state().playing);
        live.source->play(true);
        std::uint64_t moments = 0;
        std::uint64_t last = 0;
        REQUIRE(live.eventually([&] {
            const MomentPtr now = live.source->newest(); // looked at all the time
            moments += now->number != last ? 1 : 0;
            last = now->number;
            return live.source->state().ended;
        }));
        const std::int64_t all = 2000;
        REQUIRE(live.reaches(all));
        CHECK(moments > 2);
        auto unseen = run::simulate(live.scene, 1);
        REQUIRE(unseen.ok());
        REQUIRE(!(*unseen)->advance(all));
        const observe::Frame expected = (*unseen)->frame();
        const MomentPtr seen = live.source->newest();
        CHECK(seen->frame.position == expected.position);
        CHECK(seen->frame.velocity == expected.velocity);
        CHECK(seen->frame.angular_velocity == expected.angular_velocity);
        CHECK(seen->books->kinetic_translation == (*unseen)->books().kinetic_translation);
    }
}

TEST_CASE("gravity that is turned about pulls the other way from that step on") {
    // A ball in free fall, 100 steps of 1e-5 s down and 100 up. The solver's velocity stands half a step before its
    // positions (leapfrog), and to either end of a step half a pull is added: -(99.5 + 0.5) and then -99.5 + 100 + 0.5
    // of g dt.
    Live live(test::falling_ball);
    live.source->step(100);
    REQUIRE(live.reaches(100));
    const double down = live.source->newest()->frame.velocity[0].y();
    CHECK(down == about(-100 * 9.81e-5, 1e-9));
    live.source->change({{"gravity_m_s2=[0, 9.81, 0]"}});
    live.source->step(100);
    REQUIRE(live.reaches(200));
    CHECK(live.source->newest()->frame.velocity[0].y() == about(9.81e-5, 1e-9));
    CHECK(live.source->state().trouble.empty());
}

TEST_CASE("a shaking floor takes up its new amplitude where a period ends, without a jump, and says that it waits") {
    Live live(test::pouring); // the floor at 50 Hz with 0.5 mm: a period is 1000 steps
    live.source->step(250);   // at the top
    REQUIRE(live.reaches(250));
    live.source->change({{"wall.floor.motion.0.amplitude_m=0.0015"}});
    REQUIRE(live.eventually([&] { return live.source->state().change_waits; }));
    live.source->step(1); // 251: still the old motion
    REQUIRE(live.reaches(251));
    const auto height = [&] { return live.source->newest()->frame.walls[0].translation.y(); };
    const auto floor_at = [](std::int64_t step, double amplitude) {
        return amplitude * std::sin(2 * std::numbers::pi * 50 * static_cast<double>(step) * 2e-5);
    };
    CHECK(std::abs(height() - floor_at(251, 5e-4)) < 1e-12);
    live.source->step(1000); // through the period's end to a quarter of the next
    REQUIRE(live.reaches(1251));
    CHECK(!live.source->state().change_waits);
    CHECK(std::abs(height() - floor_at(251, 1.5e-3)) < 1e-9);
}

TEST_CASE("a change that the scene refuses is told, and the simulation goes on as it was") {
    Live live(test::falling_ball);
    live.source->change({{"pair.glass-glass.restitution=7"}});
    REQUIRE(live.eventually([&] { return !live.source->state().trouble.empty(); }));
    CHECK(live.source->state().trouble.find("this change was not taken up") == 0);
    live.source->step(10);
    CHECK(live.reaches(10));
    live.source->change({}); // as it was: nothing is refused any more
    CHECK(live.eventually([&] { return live.source->state().trouble.empty(); }));
}

TEST_CASE("a simulation that dies says why and stands still, and its source lives on") {
    // A ball that flies out of the domain.
    Live live(test::falling_ball, {{"fill.0.velocity_m_s=[50, 0, 0]"}});
    live.source->play(true);
    REQUIRE(live.eventually([&] { return !live.source->state().trouble.empty(); }));
    CHECK(live.source->state().trouble.find("the simulation cannot go on") == 0);
    CHECK(live.source->state().ended);
    live.source->play(true);
    CHECK(!live.source->state().playing);
    // Nor does it step any more: what is asked for afterwards shows the same instant.
    const std::int64_t died = [&] {
        live.source->show_contacts(true);
        CHECK(live.eventually([&] { return live.source->newest()->frame.contacts.has_value(); }));
        return live.source->newest()->frame.step;
    }();
    live.source->step(100);
    live.source->show_contacts(false);
    CHECK(live.eventually([&] { return !live.source->newest()->frame.contacts; }));
    CHECK(live.source->newest()->frame.step == died);
}

TEST_CASE("a change of a scene that stands still leaves the contacts that are seen until a step is taken") {
    Live live(test::pouring);
    live.source->show_contacts(true);
    live.source->step(1500);
    REQUIRE(live.eventually([&] {
        const MomentPtr now = live.source->newest();
        return now->frame.step == 1500 && now->frame.contacts;
    }));
    const MomentPtr before = live.source->newest();
    REQUIRE(!before->frame.contacts->empty());
    const auto parts = [](const observe::Frame& frame) {
        std::vector<std::pair<std::int64_t, std::int64_t>> all;
        for (const observe::FrameContact& contact : *frame.contacts)
            all.emplace_back(contact.a, contact.b);
        return all;
    };
    for (const char* friction : {"0.1", "0.2"}) { // twice, as of a slider on its way
        const std::uint64_t number = live.source->newest()->number;
        live.source->change({{std::string("pair.glass-glass.friction=") + friction}});
        REQUIRE(live.eventually([&] { return live.source->newest()->number > number; }));
        CHECK(parts(live.source->newest()->frame) == parts(before->frame));
    }
    live.source->step(1);
    REQUIRE(live.reaches(1501));
    CHECK(!live.source->newest()->frame.contacts->empty());
}

TEST_CASE("moments say who touches whom while that is wanted, also of a simulation that stands still") {
    Live live(test::pouring);
    live.source->step(1500); // 30 ms at 1 m/s and more: they meet the floor and each other
    REQUIRE(live.reaches(1500));
    CHECK(live.source->can_show_contacts());
    CHECK(!live.source->newest()->frame.contacts);
    live.source->show_contacts(true);
    REQUIRE(live.eventually([&] { return live.source->newest()->frame.contacts.has_value(); }));
    const observe::Frame frame = live.source->newest()->frame;
    CHECK(frame.step == 1500);
    CHECK(!frame.contacts->empty());
    for (const observe::FrameContact& contact : *frame.contacts)
        CHECK(std::find(frame.id.begin(), frame.id.end(), contact.a) != frame.id.end());
    live.source->show_contacts(false);
    CHECK(live.eventually([&] { return !live.source->newest()->frame.contacts; }));
}

TEST_CASE("Box2D's scenes can be watched, not changed") {
    Live live(test::raining, {{"solver=\"box2d\""}, {"domain.periodic=[]"}});
    CHECK(!live.source->can_change());
    live.source->step(2);
    CHECK(live.reaches(2));
}

} // namespace test_live_source
