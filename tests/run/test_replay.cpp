#include "../folder.h"
#include "about.h"
#include "observe/frame_file.h"
#include "run/redraw.h"
#include "run/run_scene.h"
#include "scenes.h"

#include <doctest/doctest.h>

namespace test_replay {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// A folder with a finished run of five frames.
fs::path finished_run(const Folder& folder) {
    run::RunOptions options;
    options.folder = folder.path / "ball";
    run::RunListener silent;
    const auto summary = run::run_scene(loaded(falling_ball), options, silent);
    REQUIRE_MESSAGE(summary.ok(), to_string(summary.problems()));
    return options.folder;
}

void silent(std::int64_t, std::int64_t) {}

} // namespace

TEST_CASE("a run is redrawn with other settings, in whole or in part, without simulating") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    const std::string series = content_of(run / "series.csv");
    run::RedrawOptions options;
    options.settings = loaded(falling_ball).render;
    options.settings.camera = "top";
    options.settings.color = "vy";
    options.targets.folder = folder.path / "drawn";
    options.when.from = 0.004;
    options.when.to = 0.016;
    const auto done = run::redraw(run, options, silent);
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
    CHECK(done->frames == 3); // 0.005, 0.010, 0.015
    CHECK(done->first == about(0.005));
    CHECK(done->last == about(0.015));
    CHECK(count_files(options.targets.folder, ".png") == 3);
    CHECK(content_of(run / "series.csv") == series);

    const Problems again = run::redraw(run, options, silent).problems();
    REQUIRE(again.size() == 1);
    CHECK(again[0].what == "is there already, and nothing is overwritten");
    options.overwrite = true;
    options.when.from = 0.012;
    REQUIRE(run::redraw(run, options, silent).ok());
    CHECK(count_files(options.targets.folder, ".png") == 1); // older pictures do not stay among the new ones
}

TEST_CASE("a measure that the run did not keep gives a warning in place of the small plot") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    run::RedrawOptions options;
    options.settings = loaded(falling_ball).render;
    options.targets.folder = folder.path / "drawn";
    options.settings.plot_measure = "rms_velocity_x";
    const auto done = run::redraw(run, options, silent);
    REQUIRE(done.ok());
    REQUIRE(done->warnings.size() == 1);
    CHECK(done->warnings[0] ==
          "there is no small plot: the series of this run has no rms_velocity_x; `--plot` takes what "
          "observe.measures had it keep");
}

TEST_CASE("a cut takes the frames at its ends, which sit at the nearest step, and keeps their numbers") {
    const Folder folder;
    run::RunOptions running;
    running.folder = folder.path / "ball";
    run::RunListener listener;
    // Frames at steps 0, 167, 333, 500, 667 of 3e-5 s: 0.00501, 0.00999, 0.015, 0.02001.
    REQUIRE(run::run_scene(loaded(falling_ball, {"time_step_s=3e-5"}), running, listener).ok());
    run::ExportOptions options;
    options.paraview = folder.path / "vtk";
    options.when.from = 0.01;
    options.when.to = 0.02;
    const auto done = run::export_run(running.folder, options, silent);
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
    CHECK(done->frames == 3);
    CHECK(done->first == about(0.00999));
    CHECK(done->last == about(0.02001));
    for (const char* name : {"bodies_000002.vtp", "bodies_000003.vtp", "bodies_000004.vtp"})
        CHECK_MESSAGE(fs::exists(options.paraview / name), name);
    run::RedrawOptions drawing;
    drawing.settings = loaded(falling_ball).render;
    drawing.targets.folder = folder.path / "drawn";
    drawing.when = options.when;
    REQUIRE(run::redraw(running.folder, drawing, silent).ok());
    CHECK(fs::exists(drawing.targets.folder / "frame_000004.png"));
    CHECK_FALSE(fs::exists(drawing.targets.folder / "frame_000000.png"));
}

TEST_CASE("a redrawing has one scale of colours in all its pictures: that of the fastest frame") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    // The ball falls at g t, at the end 9.81 m/s2 * 0.02 s = 0.196 m/s; rounded up, 0.2 m/s.
    const std::array<double, 2> ends{0, 0.2};
    const auto recording = run::open_recording(run, {});
    REQUIRE(recording.ok());
    CHECK(*run::colors_for({&*recording, 1}, "speed") == ends);
    CHECK(*run::colors_for({&*recording, 1}, "vy") == std::array<double, 2>{-0.2, 0.2});
    CHECK(!run::colors_for({&*recording, 1}, "sped").ok());
    run::RedrawOptions options;
    options.settings = loaded(falling_ball, {"render.width_px=640", "render.height_px=360"}).render;
    const auto drawn = [&](const char* name) {
        options.targets.folder = folder.path / name;
        REQUIRE(run::redraw(run, options, silent).ok());
        return content_of(options.targets.folder / "frame_000001.png"); // of 0.05 m/s
    };
    const std::string automatic = drawn("automatic");
    options.settings.range = ends;
    CHECK(drawn("fixed") == automatic);
    options.settings.range = {0, 0.1};
    CHECK(drawn("narrower") != automatic);
}

TEST_CASE("a redrawing may give walls another opacity and the picture another title") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    run::RedrawOptions options;
    options.settings =
        loaded(falling_ball, {"render.camera=top", "render.width_px=640", "render.height_px=360"}).render;
    options.when.to = 0;
    const auto drawn = [&](const char* name) {
        options.targets.folder = folder.path / name;
        REQUIRE(run::redraw(run, options, silent).ok());
        return content_of(options.targets.folder / "frame_000000.png");
    };
    const std::string usual = drawn("usual");
    options.title = "A ball that falls";
    options.wall_opacity = {0.25};
    CHECK(drawn("same") == usual);
    options.wall_opacity = {1};
    CHECK(drawn("opaque") != usual);
    options.wall_opacity = {0.25};
    options.title = "Another";
    CHECK(drawn("titled") != usual);
}

TEST_CASE("a redrawing says of a run that did not end how it ended") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    run::ExportOptions options;
    options.overwrite = true;
    options.text_dump = folder.path / "all.dump";
    const auto warned = [&](const std::string& summary) {
        put(run / "run.json", summary);
        const auto done = run::export_run(run, options, silent);
        REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
        return done->warnings.empty() ? "" : done->warnings[0];
    };
    CHECK(warned(R"({"state": "finished", "time_s": 0.02})").empty());
    CHECK(warned(R"({"state": "running", "time_s": 0.01})") ==
          "this run did not end: it was killed, or is still going on; run.json knows of t = 0.01 s");
    CHECK(warned(R"({"state": "stopped", "time_s": 0.01})") == "this run was stopped; run.json knows of t = 0.01 s");
    CHECK(warned("{") == "run.json cannot be read, so that nobody knows whether the run reached its end");
}

TEST_CASE("where every frame is damaged the first is named, with what is wrong with it") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    for (const fs::path& file : observe::list_frames(run / "frames"))
        put(file, content_of(file).substr(0, 100));
    run::ExportOptions options;
    options.text_dump = folder.path / "all.dump";
    const Problems problems = run::export_run(run, options, silent).problems();
    REQUIRE(problems.size() == 5);
    CHECK(problems[0].file == (run / "frames/frame_000000.tumble").string());
    CHECK(problems[0].what.find("time asked for") == std::string::npos);
}

TEST_CASE("frames of a killed run that cannot be read are left out with a warning") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    const auto files = observe::list_frames(run / "frames");
    put(files[2], content_of(files[2]).substr(0, 100));
    put(run / "frames" / "frame_000005.tumble.part", "begun");
    run::ExportOptions options;
    options.paraview = folder.path / "vtk";
    options.text_dump = folder.path / "all.dump";
    const auto done = run::export_run(run, options, silent);
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
    CHECK(done->frames == 4);
    REQUIRE(done->warnings.size() == 1);
    CHECK(done->warnings[0].find("frame_000002.tumble") != std::string::npos);
    CHECK(count_files(options.paraview, ".vtp") == 12);
    CHECK(count_files(options.paraview, ".pvd") == 3);
    CHECK_FALSE(content_of(options.text_dump).empty());
}

TEST_CASE("where frames are missing is told, once, and not where the run merely ends between two of them") {
    const Folder folder;
    run::RunOptions running;
    running.folder = folder.path / "ball";
    run::RunListener listener;
    // Frames at 0, 2, 4, ... 20 ms and at the end.
    REQUIRE(run::run_scene(loaded(falling_ball, {"render.every_s=0.002", "duration_s=0.021"}), running, listener).ok());
    const auto warnings = [&](const run::ReplayOptions& when = {}) {
        const auto recording = run::open_recording(running.folder, when, run::Reading::heads);
        REQUIRE(recording.ok());
        CHECK(run::pace_of(recording->frames) == about(0.002));
        return recording->warnings;
    };
    CHECK(warnings().empty());
    const auto frames = observe::list_frames(running.folder / "frames");
    REQUIRE(frames.size() == 12);
    fs::remove(frames[3]);
    CHECK(warnings() == std::vector<std::string>{"frames are missing between t = 0.004 and 0.008 s, 1 in all: trails "
                                                 "have gaps there, and means go without them"});
    CHECK(warnings({.from = 0.004, .to = 0.008}).size() == 1); // of two frames that are not neighbours
    CHECK(warnings({.from = 0.01}).empty());
    fs::remove(frames[6]);
    fs::remove(frames[7]);
    CHECK(warnings()[0].starts_with("frames are missing between t = 0.004 and 0.008 s and in 1 other place, 3 in all"));
}

TEST_CASE("a trail of a body that the run has not is refused with those there are, and so are two of one body") {
    const Folder folder;
    const auto recording = run::open_recording(finished_run(folder), {});
    REQUIRE(recording.ok());
    const auto problems = [&](const std::vector<std::string>& trails) {
        return run::check_trails({&*recording, 1}, trails).problems();
    };
    CHECK(problems({}).empty());
    CHECK(problems({"0"}).empty());
    CHECK(problems({"ball"}).empty());
    for (const char* nobody : {"1", "00", "bell"}) {
        REQUIRE(problems({"0", nobody}).size() == 1);
        CHECK(problems({"0", nobody})[0].key == "render.trails");
        CHECK(problems({"0", nobody})[0].what.starts_with(std::string("there is no body '") + nobody + "'"));
        CHECK(problems({"0", nobody})[0].fix == "take an id from 0 to 0, or ball for the first of that name");
    }
    REQUIRE(problems({"ball", "0"}).size() == 1);
    CHECK(problems({"ball", "0"})[0].what == "the trails of 'ball' and '0' are those of one body");
}

TEST_CASE("pictures in which no body is to be seen are told, with why") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    const auto warned = [&](const std::vector<std::string>& sets, double to = 1) {
        run::RedrawOptions options;
        options.settings = loaded(falling_ball, sets).render;
        options.settings.plot_measure = "centre_of_mass_y"; // which the run has kept
        options.targets.folder = folder.path / "drawn";
        options.overwrite = true;
        options.when.to = to;
        const auto done = run::redraw(run, options, silent);
        REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
        return done->warnings.empty() ? std::string() : done->warnings.back();
    };
    CHECK(warned({}) == "");
    const std::vector<std::string> low{"render.clip_lo_m=[-1,-1,-1]", "render.clip_hi_m=[1,0.4,1]"};
    CHECK(warned(low).starts_with("no body is to be seen in any of these pictures: the clip or cut leaves none"));
    CHECK(warned(low, 0).starts_with("no body is to be seen in this picture: "));
    // The ball is at first at 0.5 m, falls by 2 mm and has a radius of 10 mm: cut open at 0.495 m it is seen.
    CHECK(warned({"render.clip_lo_m=[-1,-1,-1]", "render.clip_hi_m=[1,0.495,1]", "render.clip_cuts=true"}) == "");
    for (const char* projection : {"orthographic", "perspective"})
        CHECK(warned({"render.camera=free", "render.eye_m=[0.3,0.1,0]", "render.target_m=[0,0,0]",
                      std::string("render.projection=") + projection, "render.field_of_view_deg=20"})
                  .find("all lie outside of what the camera shows") != std::string::npos);
    CHECK(warned({"render.camera=free", "render.eye_m=[0,0.5,0.3]", "render.target_m=[0,0.5,1]",
                  "render.projection=perspective"})
              .find("all lie outside") != std::string::npos); // behind the eye
    CHECK(warned({"render.view_lo_m=[-0.1,0,-0.1]", "render.view_hi_m=[0.1,0.1,0.1]"})
              .find("all lie outside of render.view_lo_m to render.view_hi_m") != std::string::npos);
}

TEST_CASE("an opened run knows its frames' times; where heads were enough, what is damaged is found when it is read") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    const auto whole = run::open_recording(run, {});
    REQUIRE(whole.ok());
    REQUIRE(whole->frames.size() == 5);
    CHECK(whole->frames[1].time == about(0.005));
    CHECK(!whole->frames[1].contacts);
    CHECK(whole->bounds.max().y() == about(0.51)); // a ball of 10 mm, at first at 0.5 m
    const auto heads = run::open_recording(run, {}, run::Reading::heads);
    REQUIRE(heads.ok());
    CHECK(heads->frames.size() == 5);
    CHECK(heads->bounds.isEmpty());
    std::string bytes = content_of(whole->frames[2].file);
    bytes[bytes.size() - 20] = static_cast<char>(bytes[bytes.size() - 20] ^ 0x10);
    put(whole->frames[2].file, bytes);
    CHECK(run::open_recording(run, {})->frames.size() == 4);
    const auto blind = run::open_recording(run, {}, run::Reading::heads);
    REQUIRE(blind.ok());
    CHECK(blind->frames.size() == 5);
    const run::Replayed replayed = run::replay(*blind, {}, {}, silent);
    CHECK(replayed.frames == 4);
    REQUIRE(replayed.warnings.size() == 1);
    CHECK(replayed.warnings[0].find("frame_000002.tumble") != std::string::npos);
}

TEST_CASE("what is no run, or has no frame in the time asked for, is refused and leaves nothing") {
    const Folder folder;
    run::RedrawOptions options;
    options.settings = loaded(falling_ball).render;
    options.targets.folder = folder.path / "drawn";
    CHECK(run::redraw(folder.path / "none", options, silent).problems()[0].what == "there is no such folder");
    CHECK(run::redraw(folder.path, options, silent).problems()[0].what.find("not the folder of a run") !=
          std::string::npos);
    const fs::path run = finished_run(folder);
    options.when.from = 9;
    const Problems problems = run::redraw(run, options, silent).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "there is no readable frame in the time asked for");
    CHECK(problems[0].fix == "the nearest is at 0.02 s; they go from 0 to 0.02 s");
    options.when.from = 0;
    options.settings.color = "colour of money";
    CHECK_FALSE(run::redraw(run, options, silent).ok());
    CHECK_FALSE(fs::exists(folder.path / "drawn"));
}

} // namespace test_replay
