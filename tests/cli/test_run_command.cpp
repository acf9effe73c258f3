#include "process.h"
#include "video.h"

#include <nlohmann/json.hpp>

namespace test_run_command {

using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

nlohmann::json summary_in(const fs::path& run) {
    return nlohmann::json::parse(content_of(run / "run.json"));
}

std::size_t lines_of(const fs::path& file) {
    const std::string text = content_of(file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

bool any_part(const fs::path& folder) {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".part" || entry.path().filename() == ".reserve")
            return true;
    return false;
}

/// A run that would take hours, started and seen to be under way.
Process long_run(const Folder& folder, const std::vector<std::string>& flags = {}) {
    put(folder.path / "ball.toml", bouncing_ball(1e5));
    std::vector<std::string> words{"run", "ball.toml"};
    words.insert(words.end(), flags.begin(), flags.end());
    Process process(folder.path, words);
    REQUIRE(eventually([&] { return fs::exists(folder.path / "out/ball/frames/frame_000003.tumble"); }));
    return process;
}

} // namespace

TEST_CASE("a run prints its result to stdout, its progress to stderr, and nothing when quiet") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    const Outcome loud = tumble_in(folder, {"run", "ball.toml"});
    CHECK(loud.code == 0);
    CHECK(contains(loud.out, "out/ball: finished at t = 0.02 s after 2000 steps, 1 body"));
    CHECK(contains(loud.err, "2000 steps into out/ball"));
    CHECK_FALSE(any_part(folder.path / "out"));
    CHECK(lines_of(folder.path / "out/ball/series.csv") == 22);
    const Outcome quiet = tumble_in(folder, {"run", "ball.toml", "--quiet", "--out", "other"});
    CHECK(quiet.code == 0);
    CHECK(quiet.out.empty());
    CHECK(quiet.err.empty());
    const Outcome twice = tumble_in(folder, {"run", "ball.toml"});
    CHECK(twice.code == 2);
    CHECK(contains(twice.err, "nothing is overwritten"));
    CHECK(contains(twice.err, "--force"));
    CHECK(tumble_in(folder, {"run", "ball.toml", "--force"}).code == 0);
}

TEST_CASE("Ctrl-C ends a run with code 130 and leaves a usable folder") {
    const Folder folder;
    Process process = long_run(folder);
    process.send(SIGINT);
    const Outcome outcome = process.wait();
    CHECK(outcome.code == 130);
    CHECK(contains(outcome.out, "stopped"));
    const auto summary = summary_in(folder.path / "out/ball");
    CHECK(summary["state"] == "stopped");
    CHECK(lines_of(folder.path / "out/ball/series.csv") == summary["rows"].get<std::size_t>() + 1);
    CHECK_FALSE(any_part(folder.path / "out"));
    const Outcome drawn = tumble_in(folder, {"render", "out/ball", "--time", "0:0.02", "--json", "--quiet"});
    CHECK_MESSAGE(drawn.code == 0, drawn.err);
    CHECK(nlohmann::json::parse(drawn.out)["frames"] == 3);
    CHECK(fs::exists(folder.path / "out/ball/redrawn/front_speed/frame_000002.png"));
}

TEST_CASE("a termination signal does the same with code 143") {
    const Folder folder;
    Process process = long_run(folder);
    process.send(SIGTERM);
    CHECK(process.wait().code == 143);
    CHECK(summary_in(folder.path / "out/ball")["state"] == "stopped");
}

TEST_CASE("Ctrl-C reaches ffmpeg too, and the video is whole all the same") {
    if (!can_check_videos())
        return;
    const Folder folder;
    Process process = long_run(folder, {"--video", "--set", "render.every_s=1"});
    process.send_to_all(SIGINT);
    const Outcome outcome = process.wait();
    CHECK_MESSAGE(outcome.code == 130, outcome.err);
    const auto summary = summary_in(folder.path / "out/ball");
    CHECK(summary["state"] == "stopped");
    CHECK(probed(folder.path / "out/ball/video.mp4") == "160,120," + summary["frames"].dump());
    CHECK_FALSE(any_part(folder.path / "out"));
}

TEST_CASE("a killed run is redrawn and exported from what it left") {
    const Folder folder;
    Process process = long_run(folder);
    REQUIRE(eventually([&] { return summary_in(folder.path / "out/ball")["time_s"] > 0; }));
    process.send(SIGKILL);
    CHECK(process.wait().code == 137);
    const auto summary = summary_in(folder.path / "out/ball");
    CHECK(summary["state"] == "running");
    CHECK(summary["frames"] > 0);
    CHECK(contains(tumble_in(folder, {"export", "out/ball", "--dump", "a.dump", "--time", ":0.01"}).err,
                   "this run did not end"));
    const Outcome drawn = tumble_in(folder, {"render", "out/ball", "--camera", "side", "--color", "vy", "--time",
                                             ":0.01", "--out", "drawn", "--quiet"});
    CHECK_MESSAGE(drawn.code == 0, drawn.err);
    CHECK(fs::exists(folder.path / "drawn/frame_000001.png"));
    const Outcome exported = tumble_in(folder, {"export", "out/ball", "--vtk", "vtk", "--time", "0:0.02"});
    CHECK_MESSAGE(exported.code == 0, exported.err);
    CHECK(fs::exists(folder.path / "vtk/walls_000002.vtp"));
}

TEST_CASE("a run that breaks down has code 1 and says why") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.05));
    const Outcome outcome = tumble_in(folder, {"run", "ball.toml", "--set", "fill.0.velocity_m_s=[40, 0, 0]"});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.out, "failed"));
    CHECK(contains(outcome.err, "error: "));
    CHECK(summary_in(folder.path / "out/ball")["state"] == "failed");
}

TEST_CASE("a missing ffmpeg is said before the first step, and nothing is left behind") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    const Outcome outcome = tumble_in(folder, {"run", "ball.toml", "--video"}, {"PATH=/nowhere"});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "ffmpeg"));
    CHECK_FALSE(fs::exists(folder.path / "out"));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    const Outcome redrawn = tumble_in(folder, {"render", "out/ball", "--video", "b.mp4"}, {"PATH=/nowhere"});
    CHECK(redrawn.code == 2);
    CHECK(contains(redrawn.err, "ffmpeg"));
    CHECK_FALSE(fs::exists(folder.path / "b.mp4"));
}

TEST_CASE("a folder that cannot be made is said with its name") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    put(folder.path / "file", "x");
    const Outcome below_file = tumble_in(folder, {"run", "ball.toml", "--out", "file/run"});
    CHECK(below_file.code == 2);
    CHECK(contains(below_file.err, "file/run: cannot be made"));
    CHECK(contains(below_file.err, "--out"));
    const Outcome no_place = tumble_in(folder, {"run", "ball.toml", "--out", "/proc/tumble"});
    CHECK(no_place.code == 2);
    CHECK(contains(no_place.err, "error: /proc/tumble: cannot be made: "));
    CHECK(std::count(no_place.err.begin(), no_place.err.end(), '\n') == 2); // what is wrong, and what to do
    CHECK(contains(no_place.err, "\n    choose another folder with --out DIR\n"));
}

TEST_CASE("wrong times and sizes of a drawing are said") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    for (const std::string time : {"1", "a:b", "2:1", "1:2:3"}) {
        const Outcome outcome = tumble_in(folder, {"render", "out/ball", "--time", time});
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, time == "2:1" ? "--time 2:1 ends before it begins" : "is no stretch of time"));
        CHECK(contains(outcome.err, "0.5: or :1.5; the frames of out/ball go from 0 to 0.02 s"));
    }
    const Outcome late = tumble_in(folder, {"render", "out/ball", "--time", "5:"});
    CHECK(late.code == 2);
    CHECK(contains(late.err, "the nearest is at 0.02 s"));
    CHECK(tumble_in(folder, {"render", "out/ball", "--size", "wide"}).code == 2);
    const Outcome camera = tumble_in(folder, {"render", "out/ball", "--camera", "fornt"});
    CHECK(camera.code == 2);
    CHECK(contains(camera.err, "front"));
    CHECK(tumble_in(folder, {"render", "out/none"}).code == 2);
    CHECK_FALSE(fs::exists(folder.path / "out/ball/redrawn"));
}

TEST_CASE("a redrawing takes the keys that concern it and refuses those of the run") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    const Outcome refused = tumble_in(folder, {"render", "out/ball", "--set", "duration_s=9", "--set", "title=New"});
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "--set duration_s: this run is over"));
    CHECK_FALSE(refused.err.find("--set title") != std::string::npos);
    CHECK(tumble_in(folder, {"render", "out/ball", "--set", "render.every_s=1"}).code == 2);
    CHECK_FALSE(fs::exists(folder.path / "out/ball/redrawn"));
    const Outcome drawn = tumble_in(folder, {"render", "out/ball", "--set", "wall.floor.opacity=1", "--set",
                                             "title=New", "--set", "render.background=white", "--quiet"});
    CHECK_MESSAGE(drawn.code == 0, drawn.err);
}

TEST_CASE("a video with another ending than .mp4 is refused by render, before anything is run or drawn") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    for (const std::string what : {"out/ball", "ball.toml"}) {
        const Outcome outcome = tumble_in(folder, {"render", what, "--video", "x.avi", "--out", "there"});
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, "call it x.mp4"));
    }
    CHECK_FALSE(fs::exists(folder.path / "there"));
}

TEST_CASE("no folder or file is made of a dash") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"run", "ball.toml", "--out", "-"},
                                               {"render", "out/ball", "--out", "-"},
                                               {"export", "out/ball", "--vtk", "-"}})
        CHECK(tumble_in(folder, words).code == 2);
    CHECK_FALSE(fs::exists(folder.path / "-"));
}

TEST_CASE("a scene is rendered by running it") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    const Outcome outcome = tumble_in(folder, {"render", "ball.toml", "--camera", "top", "--quiet"});
    CHECK_MESSAGE(outcome.code == 0, outcome.err);
    CHECK(fs::exists(folder.path / "out/ball/pictures/frame_000002.png"));
}

TEST_CASE("a video comes out of run and of render where ffmpeg is installed") {
    if (!can_check_videos())
        return;
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.05));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--video", "--quiet"}).code == 0);
    CHECK(probed(folder.path / "out/ball/video.mp4") == "160,120,6"); // from 0 to 50 ms every 10 ms
    CHECK_FALSE(fs::exists(folder.path / "out/ball/pictures"));
    REQUIRE(tumble_in(folder, {"render", "out/ball", "--video", "side.mp4", "--camera", "side", "--quiet"}).code == 0);
    CHECK(probed(folder.path / "side.mp4") == "160,120,6");
    CHECK_FALSE(any_part(folder.path));
    const Outcome named = tumble_in(folder, {"render", "ball.toml", "--video", "top.mp4", "--out", "top"});
    CHECK(named.code == 0);
    CHECK(contains(named.out, ", top.mp4 (plays "));
    CHECK(probed(folder.path / "top.mp4") == "160,120,6");
}

} // namespace test_run_command
