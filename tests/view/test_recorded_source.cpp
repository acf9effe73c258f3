#include "../about.h"
#include "../video.h"
#include "observe/frame_file.h"
#include "recorded.h"
#include "run/replay.h"
#include "view/plots.h"

#include <numbers>
#include <stdexcept>
#include <thread>

using namespace tumble;
using namespace tumble::view;
using test::about;
using view::testing::Recorded;

namespace test_recorded_source {

TEST_CASE("a run is sought in time by its nearest frame, stepped forth and back, and never left at its ends") {
    const Recorded recorded;
    Source& source = *recorded.source;
    CHECK(source.can_seek());
    CHECK(!source.can_change());
    CHECK(recorded.time() == 0);
    CHECK(source.state().last == recorded.scene.duration);
    source.seek(0.0124);
    CHECK(source.newest()->frame.step == 1000);
    source.seek(0.0126);
    CHECK(source.newest()->frame.step == 1500);
    source.step(1);
    CHECK(source.newest()->frame.step == 2000);
    CHECK(source.state().ended);
    source.step(1);
    CHECK(source.newest()->frame.step == 2000);
    source.step(-2);
    CHECK(source.newest()->frame.step == 1000);
    source.seek(-5);
    CHECK(recorded.time() == 0);
    source.seek(5);
    CHECK(source.newest()->frame.step == 2000);
}

TEST_CASE("a run plays at the speed of its video to its last frame, and from the start when it is played again") {
    const Recorded recorded;
    Source& source = *recorded.source;
    // A frame every 5 ms at 25 frames/s: 0.125 s of the run per s.
    CHECK(source.state().speed == about(0.005 * 25, 1e-12));
    source.set_speed(10);
    source.play(true);
    for (int i = 0; i < 6000 && source.newest() && !source.state().ended; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(source.newest()->frame.step == 2000);
    CHECK(!source.state().playing);
    source.set_speed(1e-6);
    source.play(true);
    CHECK(source.newest()->frame.step == 0);
    CHECK(source.state().playing);
}

TEST_CASE("a run's film has all of its frames, and its plots are those columns of series.csv that it has") {
    const Recorded recorded;
    const std::filesystem::path film = recorded.folder.path / "film.mp4";
    recorded.source->film({recorded.scene.render}, film);
    for (int i = 0; i < 6000 && recorded.source->state().filmed.empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(recorded.source->state().filmed == film.string() + " with 5 pictures");
    if (test::can_check_videos())
        CHECK(test::probed(film) == "160,120,5");
    // This scene keeps one measure of those that have plots, a row every ms: in free fall m (g t)^2 / 2.
    const double mass = 2500 * 4.0 / 3.0 * std::numbers::pi * 1e-6; // kg
    const Plots plots = Plots::of_run(recorded.run, recorded.scene);
    REQUIRE(plots.lines().size() == 1);
    const render::PlotLine& kinetic = plots.lines().front();
    REQUIRE(kinetic.values.size() == 21);
    REQUIRE(kinetic.times.size() == 21);
    CHECK(kinetic.unit == "J");
    CHECK(kinetic.until == recorded.scene.duration);
    for (std::size_t i = 0; i < kinetic.values.size(); ++i) {
        const double time = 1e-3 * static_cast<double>(i);
        CHECK(std::abs(kinetic.times[i] - time) < 1e-12);
        CHECK(kinetic.values[i] == about(0.5 * mass * 9.81 * time * 9.81 * time, 1e-6));
    }
    CHECK(Plots::of_run(recorded.folder.path, recorded.scene).lines().empty()); // no run is there
}

TEST_CASE("a run is shown and filmed with the title and the opacity of walls that are asked for") {
    Recorded recorded;
    recorded.scene.title = "Another title";
    recorded.scene.walls[0].opacity = 0.125;
    const auto source = recorded.again();
    CHECK(source->layout()->title == "Another title");
    CHECK(source->layout()->walls[0].opacity == 0.125);
    CHECK(source->newest()->frame.layout->walls[0].opacity == 0.125);
}

TEST_CASE("what is thrown while a film is made is told, and the program lives on") {
    const Recorded recorded(false, [] { throw std::runtime_error("news that nobody takes"); });
    recorded.source->film({recorded.scene.render}, recorded.folder.path / "film.mp4");
    for (int i = 0; i < 6000 && recorded.source->state().filmed != "news that nobody takes"; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(recorded.source->state().filmed == "news that nobody takes");
    CHECK(!recorded.source->state().filming);
}

/// Half a step, 5 us, counts as no difference.
TEST_CASE(
    "in a stretch of time a run has the frames that lie in it, and what has none is refused with those there are") {
    const Recorded recorded;
    Source& source = *recorded.source;
    const auto found = [&](double from, double to) {
        const auto stretch = source.find(from, to);
        REQUIRE_MESSAGE(stretch.ok(), to_string(stretch.problems()));
        return std::pair{std::lround(1e5 * stretch->from), std::lround(1e5 * stretch->to)}; // steps
    };
    CHECK(found(0, 0.0149) == std::pair{0L, 1000L});
    CHECK(found(0, 0.014996) == std::pair{0L, 1500L});
    CHECK(found(0.0051, 7) == std::pair{1000L, 2000L});
    for (const auto& [from, to] : {std::pair{-2.0, -1.0}, {0.0051, 0.0099}, {0.021, 7.0}}) {
        const auto none = source.find(from, to);
        REQUIRE(!none.ok());
        const auto render = run::open_recording(recorded.run, {.from = from, .to = to});
        REQUIRE(!render.ok());
        CHECK(to_string(none.problems().front()) == to_string(render.problems().front()));
        CHECK(none.problems().front().fix.ends_with("they go from 0 to 0.02 s"));
    }
}

TEST_CASE("a run shows contacts where its frames kept them") {
    CHECK(!Recorded().source->can_show_contacts());
    const Recorded recorded(true);
    CHECK(recorded.source->can_show_contacts());
    CHECK(recorded.source->newest()->frame.contacts);
}

TEST_CASE("a run tells what is missing of it, and refuses the trail of a body that it has not") {
    Recorded recorded;
    CHECK(recorded.source->warnings().empty());
    recorded.scene.render.marks.trails = {"99999"};
    const auto refused = open_recorded(recorded.run, recorded.scene, [] {});
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].key == "render.trails");
    CHECK(refused.problems()[0].what.starts_with("there is no body '99999'"));
    recorded.scene.render.marks.trails = {"0"};
    const auto frames = observe::list_frames(recorded.run / "frames");
    REQUIRE(frames.size() == 5);
    std::filesystem::remove(frames[2]);
    const auto source = recorded.again();
    REQUIRE(source->warnings().size() == 1);
    CHECK(source->warnings()[0].starts_with("frames are missing between t = 0.005 and 0.015 s, 1 in all"));
}

TEST_CASE("a folder that holds no run is a problem") {
    const test::Folder folder;
    CHECK(!open_recorded(folder.path, scene::Scene{}, [] {}).ok());
}

} // namespace test_recorded_source
