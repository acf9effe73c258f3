#include "../folder.h"
#include "about.h"
#include "observe/frame_file.h"
#include "observe/series.h"
#include "run/run_folder.h"
#include "run/run_scene.h"
#include "run/simulation.h"
#include "scenes.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace test_run_scene {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

run::RunSummary ran(const scene::Scene& scene, const run::RunOptions& options) {
    run::RunListener silent;
    const auto summary = run::run_scene(scene, options, silent);
    REQUIRE_MESSAGE(summary.ok(), to_string(summary.problems()));
    return *summary;
}

Problems refused(const scene::Scene& scene, const run::RunOptions& options) {
    run::RunListener silent;
    return run::run_scene(scene, options, silent).problems();
}

std::vector<std::string> entries(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

TEST_CASE("a run leaves its folder: scene, summary, series at exact times, frames") {
    const Folder folder;
    const scene::Scene scene = loaded(falling_ball);
    run::RunOptions options;
    options.folder = folder.path / "out" / "ball";
    const run::RunSummary summary = ran(scene, options);
    CHECK(summary.state == "finished");
    CHECK(summary.steps == 2000);
    CHECK(summary.rows == 21);
    CHECK(summary.frames == 5);
    CHECK(entries(options.folder) ==
          std::vector<std::string>{"frames", "run.json", "scene.toml", "series.csv", "state"});

    const auto series = observe::read_series(options.folder / "series.csv");
    REQUIRE(series.ok());
    REQUIRE(series->rows() == 21);
    for (std::size_t i = 0; i < 21; ++i) {
        const double t = series->values[0][i];
        CHECK(t == about(0.001 * static_cast<double>(i), 1e-12));
        CHECK((*series->find("centre_of_mass_y"))[i] == about(0.5 - 0.5 * 9.81 * t * t, 1e-6));
    }
    const auto layout = observe::read_layout(observe::layout_path(options.folder / "frames"));
    REQUIRE(layout.ok());
    CHECK((*layout)->walls.at(0).name == "floor");
    const auto files = observe::list_frames(options.folder / "frames");
    REQUIRE(files.size() == 5);
    const auto frame = observe::read_frame(files[4], *layout);
    REQUIRE(frame.ok());
    CHECK(frame->time == about(0.02));
    CHECK(frame->velocity.at(0).y() == about(-9.81 * 0.02, 1e-3));

    const auto json = nlohmann::json::parse(content_of(options.folder / "run.json"));
    CHECK(json["state"] == "finished");
    CHECK(json["steps"] == 2000);
    CHECK(json["seed"] == scene.seed);
    CHECK(json["bodies"] == 1);
    CHECK(json["phases_s"].size() > 1);
    CHECK(std::abs(json["energy_closure_J"].get<double>()) < 1e-3 * json["energy_turnover_J"].get<double>());
}

TEST_CASE("the scene in the folder runs again to the same bits, on any number of threads") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "a";
    options.threads = 1;
    ran(loaded(falling_ball, {"duration_s=0.005"}), options);
    const auto again = scene::load_scene(options.folder / "scene.toml");
    REQUIRE_MESSAGE(again.ok(), to_string(again.problems()));
    run::RunOptions other;
    other.folder = folder.path / "b";
    other.threads = 2;
    ran(*again, other);
    for (const char* name : {"series.csv", "frames/layout.tumble", "frames/frame_000001.tumble"})
        CHECK_MESSAGE(content_of(options.folder / name) == content_of(other.folder / name), name);
}

TEST_CASE("nothing is overwritten, and force replaces only what a run wrote") {
    const Folder folder;
    const scene::Scene scene = loaded(falling_ball, {"duration_s=0.002"});
    run::RunOptions options;
    options.folder = folder.path;
    put(folder.path / "notes.txt", "mine");
    put(folder.path / "series.csv", "old");
    const Problems problems = refused(scene, options);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].file == folder.path.string());
    CHECK(problems[0].what == "already holds something, and nothing is overwritten");
    CHECK(problems[0].fix.find("--force") != std::string::npos);
    CHECK(entries(folder.path) == std::vector<std::string>{"notes.txt", "series.csv"});
    CHECK(content_of(folder.path / "series.csv") == "old");

    options.overwrite = true;
    CHECK(ran(scene, options).state == "finished");
    CHECK(content_of(folder.path / "notes.txt") == "mine");
    CHECK(content_of(folder.path / "series.csv").starts_with("time_s,"));
}

TEST_CASE("force takes away all that the earlier run, its redrawings and a kill left, and nothing of anybody else") {
    const Folder folder;
    const scene::Scene scene = loaded(falling_ball, {"duration_s=0.002"});
    run::RunOptions options;
    options.folder = folder.path;
    fs::create_directories(folder.path / "redrawn" / "side_vy");
    fs::create_directories(folder.path / "pictures");
    fs::create_directories(folder.path / "meshes");
    for (const char* name :
         {"redrawn/side_vy/frame_000000.png", "redrawn/side_vy/frame_000001.png.part", "video.mp4.part",
          "run.json.part", "pictures/frame_000099.png", "meshes/0.stl", ".reserve"})
        put(folder.path / name, "old");
    for (const char* name : {"pictures/choice.txt", "redrawn/side_vy/best.svg", "mine.mp4"})
        put(folder.path / name, "mine");
    options.overwrite = true;
    CHECK(ran(scene, options).state == "finished");
    CHECK(entries(folder.path) == std::vector<std::string>{"frames", "mine.mp4", "pictures", "redrawn", "run.json",
                                                           "scene.toml", "series.csv", "state"});
    CHECK(entries(folder.path / "pictures") == std::vector<std::string>{"choice.txt"});
    CHECK(entries(folder.path / "redrawn" / "side_vy") == std::vector<std::string>{"best.svg"});
}

TEST_CASE("the last state is kept as a frame where the schedule misses it") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    double end = 0.007;
    SUBCASE("at the end") {
        CHECK(ran(loaded(falling_ball, {"duration_s=0.007"}), options).frames == 3);
    }
    SUBCASE("after a failure") {
        const auto summary = ran(loaded(falling_ball, {"fill.0.velocity_m_s=[13, 0, 0]"}), options);
        CHECK(summary.state == "failed"); // 0.1 m to the side of the domain
        end = summary.time;
        CHECK(end == about(0.1 / 13, 0.1));
    }
    const auto layout = observe::read_layout(observe::layout_path(options.folder / "frames"));
    REQUIRE(layout.ok());
    const auto files = observe::list_frames(options.folder / "frames");
    REQUIRE(files.size() == 3);
    CHECK(observe::read_frame(files.back(), *layout)->time == about(end));
}

TEST_CASE("the first row of the series describes the state that the run starts from") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    ran(loaded(falling_ball, {"observe.measures=[\"bodies\", \"energies\", \"energy_closure\", \"kinetic\"]",
                              "fill.0.velocity_m_s=[0, 2, 0]", "duration_s=0.002"}),
        options);
    const auto series = observe::read_series(options.folder / "series.csv");
    REQUIRE(series.ok());
    const auto first = [&](const std::string& name) { return series->find(name)->front(); };
    const double mass = 2500 * 4.0 / 3.0 * M_PI * 1e-6;
    CHECK(first("bodies") == 1);
    CHECK(first("kinetic_translation_J") == about(0.5 * mass * 4));
    CHECK(first("gravity_energy_J") == about(mass * 9.81 * 0.5));
    CHECK(first("inserted_energy_J") == about(mass * (2 + 9.81 * 0.5)));
    CHECK(std::abs(first("energy_closure_J")) < 1e-15);
}

TEST_CASE("a run says what check warns of, and run.json keeps it") {
    const Folder folder;
    struct Ears : run::RunListener {
        std::vector<std::string> heard;
        void warned(const std::string& sentence) override { heard.push_back(sentence); }
    } ears;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    const auto summary =
        run::run_scene(loaded(falling_ball, {"duration_s=0.001", "render.every_s=1e-6"}), options, ears);
    REQUIRE(summary.ok());
    REQUIRE(ears.heard.size() == 1);
    CHECK(ears.heard[0].starts_with("render.every_s is shorter than a step: every step gets one frame, 101 in all"));
    CHECK(nlohmann::json::parse(content_of(options.folder / "run.json"))["warnings"][0] == ears.heard[0]);
}

TEST_CASE("while bodies are placed a tally hears of each, whichever solver places them, and a run's listener with it") {
    for (const scene::Scene& scene : {loaded(pouring), loaded(raining),
                                      loaded(raining, {"solver=box2d", "domain.periodic=[]"}), loaded(falling_ball)}) {
        CAPTURE(scene.title);
        std::int64_t wanted = 0, heard = 0;
        for (const scene::Fill& fill : scene.fills)
            wanted += *fill.count;
        const auto simulation =
            run::simulate(scene, 1, nullptr, [&](std::string_view what, std::int64_t done, std::int64_t all) {
                CHECK(what == "bodies placed");
                CHECK(done == ++heard);
                CHECK(all == wanted);
            });
        REQUIRE_MESSAGE(simulation.ok(), to_string(simulation.problems()));
        CHECK(heard > 0);
        CHECK(heard == (*simulation)->books().bodies);
    }
    const Folder folder;
    struct Ears : run::RunListener {
        std::vector<std::string> heard;
        void prepares(std::string_view what, std::int64_t done, std::int64_t all) override {
            heard.push_back(std::to_string(done) + " of " + std::to_string(all) + " " + std::string(what));
        }
        void started(const fs::path&, const run::Progress&) override { heard.emplace_back("started"); }
    } ears;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    REQUIRE(run::run_scene(loaded(falling_ball, {"duration_s=0.001"}), options, ears).ok());
    CHECK(ears.heard == std::vector<std::string>{"1 of 1 bodies placed", "started"});
}

TEST_CASE("a body at rest without gravity misses no energy worth a warning") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    const auto summary =
        ran(loaded(falling_ball, {"gravity_m_s2=[1e-9, -1, 0]", "duration_s=1e-5", "observe.every_s=1e-5"}), options);
    CHECK(summary.warnings.empty());
}

TEST_CASE("meshes come along: the folder runs again where the first files are gone, even into itself") {
    const Folder folder;
    const std::string mesh = content_of(TUMBLE_ROOT "/tests/scene/data/tetrahedron.stl");
    put(folder.path / "lid.stl", mesh);
    put(folder.path / "ball.toml", falling_ball + "[[wall]]\nname = \"lid\"\nstl = \"lid.stl\"\nscale = 0.001\n"
                                                  "material = \"glass\"\n");
    const auto scene = scene::load_scene(folder.path / "ball.toml", {{"duration_s=0.001"}});
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    run::RunOptions options;
    options.folder = folder.path / "a";
    ran(*scene, options);
    CHECK(content_of(folder.path / "a/meshes/0.stl") == mesh);
    fs::remove(folder.path / "lid.stl");
    fs::rename(folder.path / "a", folder.path / "b");
    const auto again = scene::load_scene(folder.path / "b/scene.toml");
    REQUIRE_MESSAGE(again.ok(), to_string(again.problems()));
    options.folder = folder.path / "b";
    options.overwrite = true;
    ran(*again, options);
    CHECK(content_of(folder.path / "b/meshes/0.stl") == mesh);
}

TEST_CASE("a run that cannot start costs the one that it was to replace nothing") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    ran(loaded(falling_ball, {"duration_s=0.002"}), options);
    const std::string series = content_of(options.folder / "series.csv");
    const std::string summary = content_of(options.folder / "run.json");
    options.overwrite = true;
    options.video = true;
    options.video_file = folder.path / "nowhere" / "a.mp4"; // refused where ffmpeg is missing, too
    CHECK_FALSE(refused(loaded(falling_ball), options).empty());
    CHECK(entries(options.folder) ==
          std::vector<std::string>{"frames", "run.json", "scene.toml", "series.csv", "state"});
    CHECK(content_of(options.folder / "series.csv") == series);
    CHECK(content_of(options.folder / "run.json") == summary);
    CHECK(observe::list_frames(options.folder / "frames").size() == 2);
}

TEST_CASE("a stop between two steps leaves a usable folder that says so") {
    const Folder folder;
    std::atomic<bool> stop{false};
    struct Stopper : run::RunListener {
        std::atomic<bool>& stop;
        explicit Stopper(std::atomic<bool>& flag) : stop(flag) {}
        void progressed(const run::Progress& now) override {
            if (now.step >= 700)
                stop = true;
        }
    } listener(stop);
    run::RunOptions options;
    options.folder = folder.path / "ball";
    options.stop = &stop;
    const auto summary = run::run_scene(loaded(falling_ball), options, listener);
    REQUIRE(summary.ok());
    CHECK(summary->state == "stopped");
    CHECK(summary->steps >= 700);
    CHECK(summary->steps < 2000);
    const auto series = observe::read_series(options.folder / "series.csv");
    REQUIRE(series.ok());
    CHECK(static_cast<std::int64_t>(series->rows()) == summary->rows);
    CHECK(nlohmann::json::parse(content_of(options.folder / "run.json"))["state"] == "stopped");
    const auto files = observe::list_frames(options.folder / "frames");
    CHECK(static_cast<std::int64_t>(files.size()) == summary->frames);
    const auto layout = observe::read_layout(observe::layout_path(options.folder / "frames"));
    REQUIRE(layout.ok());
    CHECK(observe::read_frame(files.back(), *layout)->step == summary->steps); // what was seen last
}

TEST_CASE("what cannot start leaves nothing behind") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "deep" / "er" / "ball";
    SUBCASE("an unknown measure") {
        const Problems problems = refused(loaded(falling_ball, {"observe.measures=[\"circulaton\"]"}), options);
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what == "there is no measure 'circulaton'");
        CHECK(problems[0].file == "--set observe.measures");
    }
    SUBCASE("an unknown measure of the plot, also where nothing is drawn") {
        std::string text = falling_ball;
        text += "plot_measure = \"circulaton\"\n";
        const Problems problems = refused(loaded(text), options);
        REQUIRE(problems.size() == 1);
        CHECK(to_string(problems[0]) == "ball.toml:36:16: there is no measure 'circulaton'\n    did you mean "
                                        "'circulation'? `tumble list measures` names all of them");
    }
    SUBCASE("a plot of several measures at once") {
        const Problems problems = refused(loaded(falling_ball, {"render.plot_measure=kinetic"}), options);
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what == "'kinetic' names 2 measures, and the small plot shows one");
        CHECK(problems[0].fix == "write one of kinetic_translation, kinetic_rotation");
    }
    SUBCASE("a time step above the stable limit") {
        CHECK_FALSE(refused(loaded(falling_ball, {"time_step_s=1e-3"}), options).empty());
    }
    SUBCASE("a folder below a file") {
        put(folder.path / "deep", "a file");
        CHECK_FALSE(refused(loaded(falling_ball), options).empty());
        fs::remove(folder.path / "deep");
    }
    SUBCASE("a disk that is too small for the frames") {
        // A frame of one body takes more than 100 bytes; 1e12 frames fit on no disk of this world.
        const Problems problems =
            refused(loaded(falling_ball, {"duration_s=1e6", "render.every_s=1e-6", "time_step_s=1e-6"}), options);
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what.find("are free there") != std::string::npos);
    }
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a state that stops being sane ends the run as failed, with its reason in run.json") {
    const Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "ball";
    // Starts below the floor of the domain's only wall-less side: it leaves the domain.
    const scene::Scene scene = loaded(falling_ball, {"fill.0.velocity_m_s=[40, 0, 0]"});
    const run::RunSummary summary = ran(scene, options);
    CHECK(summary.state == "failed");
    REQUIRE_FALSE(summary.reason.empty());
    const auto json = nlohmann::json::parse(content_of(options.folder / "run.json"));
    CHECK(json["state"] == "failed");
    CHECK_FALSE(json["reason"].get<std::string>().empty());
    CHECK(summary.time < 0.02);
    CHECK(observe::read_series(options.folder / "series.csv").ok());
}

TEST_CASE("pictures are the same bytes however fast they are drawn, one per frame") {
    const Folder folder;
    const scene::Scene scene = loaded(falling_ball, {"duration_s=0.01"});
    for (const char* name : {"a", "b"}) {
        run::RunOptions options;
        options.folder = folder.path / name;
        options.pictures = true;
        options.paraview = true;
        options.text_dump = true;
        const run::RunSummary summary = ran(scene, options);
        CHECK(summary.pictures == 3);
    }
    for (const char* name : {"pictures/frame_000000.png", "pictures/frame_000002.png", "paraview/bodies.pvd",
                             "paraview/walls_000002.vtp", "spheres.dump"}) {
        CHECK_MESSAGE(!content_of(folder.path / "a" / name).empty(), name);
        CHECK_MESSAGE(content_of(folder.path / "a" / name) == content_of(folder.path / "b" / name), name);
    }
}

} // namespace test_run_scene
