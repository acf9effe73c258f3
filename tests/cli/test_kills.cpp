#include "process.h"
#include "video.h"

#include <map>
#include <nlohmann/json.hpp>
#include <random>

namespace test_kills {

using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// Balls that bounce in a crowd, for some 10,000 steps.
const std::string crowd = R"(
title = "A crowd"
claim = "none"
duration_s = 0.2
time_step_s = 2e-5
[domain]
lo_m = [-0.02, -0.01, -0.02]
hi_m = [0.02, 0.12, 0.02]
periodic = ["x", "z"]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 5e6
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.9
friction = 0.4
[body.ball]
radius_mm = 3
material = "glass"
[[fill]]
body = "ball"
count = 150
region_lo_m = [-0.02, 0.005, -0.02]
region_hi_m = [0.02, 0.08, 0.02]
velocity_m_s = [0, -1, 0]
until_s = 1
every_s = 0.0101
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "glass"
[[wall.motion]]
kind = "harmonic"
axis = "y"
amplitude_m = 0.001
frequency_Hz = 50
[observe]
every_s = 0.0005
[render]
every_s = 0.002
width_px = 96
height_px = 72
)";

/// The same of clumps that stick and resist rolling, and of balls with a paddle, a mesh that turns among them, whose
/// restitution falls and whose friction weakens with speed.
std::string sticky_clumps() {
    std::string text = crowd;
    text.replace(text.find("radius_mm = 3\n"), 14, "spheres_m = [[0, 0, 0, 0.003], [0.002, 0, 0, 0.0025]]\n");
    text.replace(text.find("friction = 0.4\n"), 15,
                 "friction = 0.4\nrolling_friction = 0.1\nwork_of_adhesion_J_m2 = 0.1\n");
    return text + "[contact]\nrolling = \"epsd\"\nadhesion = \"jkr\"\n";
}

std::string stirred() {
    std::string text = crowd;
    text.replace(text.find("friction = 0.4\n"), 15,
                 "friction = 0.4\nsliding_friction = 0.2\nsliding_speed_m_s = 0.1\nrestitution_exponent = 0.1\n"
                 "restitution_speed_m_s = 1\n");
    return text + "[[wall]]\nname = \"paddle\"\nstl = \"paddle.stl\"\nscale = 0.001\nmaterial = \"glass\"\n"
                  "[[wall.motion]]\nkind = \"rotation\"\nabout = [0, 1, 0]\ncentre_m = [0, 0, 0]\nspeed_rpm = 200\n";
}

const std::string paddle = R"(solid paddle, 16 by 20 mm
facet normal 0 0 1
  outer loop
    vertex -8 0 0
    vertex 8 0 0
    vertex 8 20 0
  endloop
endfacet
facet normal 0 0 1
  outer loop
    vertex -8 0 0
    vertex 8 20 0
    vertex -8 20 0
  endloop
endfacet
endsolid
)";

/// Every file of a run by its name, but for those that hold wall times.
std::map<std::string, std::string> content_of_run(const fs::path& run) {
    std::map<std::string, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(run))
        if (entry.is_regular_file() && entry.path().extension() != ".ckpt" && entry.path().filename() != "run.json")
            content[entry.path().lexically_relative(run).string()] = content_of(entry.path());
    return content;
}

void check_same(const std::map<std::string, std::string>& whole, const fs::path& run) {
    const auto now = content_of_run(run);
    CHECK(now.size() == whole.size());
    for (const auto& [name, content] : whole)
        CHECK_MESSAGE((now.contains(name) && now.at(name) == content), name);
}

nlohmann::json summary_in(const fs::path& run) {
    return nlohmann::json::parse(content_of(run / "run.json"));
}

int kills_wanted() {
    const char* given = std::getenv("TUMBLE_KILLS");
    return given ? std::atoi(given) : 12;
}

} // namespace

TEST_CASE("a run that is killed at random moments ends in the bits of one that never was") {
    const std::map<std::string, std::string> scenes{
        {"crowd", crowd}, {"clumps", sticky_clumps()}, {"stirred", stirred()}};
    std::mt19937 random(7);
    int kills = 0, chains = 0;
    std::size_t gone_on = 0; // from a checkpoint of a later step than the first
    for (const auto& [name, text] : scenes) {
        CAPTURE(name);
        const Folder folder;
        put(folder.path / "scene.toml", text);
        put(folder.path / "paddle.stl", paddle);
        const auto run_in = [&](const std::string& place, std::vector<std::string> more) {
            std::vector<std::string> words{"run", "scene.toml", "--out", place, "--dump", "--quiet"};
            words.insert(words.end(), more.begin(), more.end());
            return words;
        };
        const auto begun = std::chrono::steady_clock::now();
        REQUIRE(tumble_in(folder, run_in("whole", {"--threads", "1"})).code == 0);
        const std::chrono::duration<double> span = std::chrono::steady_clock::now() - begun;
        const auto whole = content_of_run(folder.path / "whole");
        const auto end = summary_in(folder.path / "whole");
        std::size_t gone_on_here = 0;
        const auto check_finished = [&](const std::string& place) {
            const Outcome last =
                tumble_in(folder, run_in(place, {"--resume", "--threads", std::to_string(1 + random() % 2)}));
            REQUIRE_MESSAGE(last.code == 0, last.err);
            check_same(whole, folder.path / place);
            const auto summary = summary_in(folder.path / place);
            for (const char* key : {"rows", "frames", "steps", "energy_closure_J", "energy_turnover_J"})
                CHECK(summary[key] == end[key]);
            for (const auto& resumption : summary["resumed"])
                gone_on_here += resumption["step"] > 0 ? 1 : 0;
            fs::remove_all(folder.path / place);
        };
        const int share = (kills_wanted() + 2) / static_cast<int>(scenes.size());
        for (int killed = 0; killed < share;) {
            // Also during the start of the program, and while it takes up what the last one left.
            const auto wait = span * std::uniform_real_distribution<>(0, 1)(random);
            Process process(folder.path, run_in("parts", {"--resume", "--checkpoint-every", "0.02", "--threads",
                                                          std::to_string(1 + random() % 2)}));
            std::this_thread::sleep_for(wait);
            process.send(SIGKILL);
            const int code = process.wait().code;
            REQUIRE((code == 137 || code == 0)); // killed, or quicker than that
            killed += code == 137 ? 1 : 0;
            if (code == 0 || killed == share) {
                check_finished("parts");
                ++chains;
            } else if (fs::exists(folder.path / "parts")) { // what this kill left, whatever later ones would mend
                fs::copy(folder.path / "parts", folder.path / "copy", fs::copy_options::recursive);
                check_finished("copy");
            }
        }
        kills += share;
        gone_on += gone_on_here;
    }
    CHECK_MESSAGE(gone_on > 0, "no kill left a checkpoint that stood in the midst of a run");
    MESSAGE(kills << " kills in " << chains << " runs, which went on from the midst of them " << gone_on << " times");
}

TEST_CASE("Ctrl-C leaves a checkpoint, from which the same command with --resume goes on") {
    const Folder folder;
    put(folder.path / "crowd.toml", crowd);
    REQUIRE(tumble_in(folder, {"run", "crowd.toml", "--out", "whole", "--frames", "--quiet"}).code == 0);
    Process process(folder.path, {"run", "crowd.toml", "--frames"});
    REQUIRE(eventually([&] { return fs::exists(folder.path / "out/crowd/frames/frame_000002.tumble"); }));
    process.send(SIGINT);
    const Outcome stopped = process.wait();
    CHECK(stopped.code == 130);
    const std::string checkpoint = summary_in(folder.path / "out/crowd")["checkpoint"];
    CHECK(contains(stopped.out, checkpoint + " is there: the same command with --resume goes on from it"));
    CHECK(contains(tumble_in(folder, {"run", "crowd.toml"}).err,
                   "the same command with --resume goes on with a run that ended early there"));
    const Outcome resumed = tumble_in(folder, {"run", "crowd.toml", "--resume"}); // with --frames, as it was begun
    CHECK_MESSAGE(resumed.code == 0, resumed.err);
    CHECK(contains(resumed.err, ", on from t = "));
    check_same(content_of_run(folder.path / "whole"), folder.path / "out/crowd");
    CHECK(summary_in(folder.path / "out/crowd")["resumed"][0]["checkpoint"] == checkpoint);
}

TEST_CASE("a run's folder stands for its run: with --resume it goes on there, without the way to say so is told") {
    const Folder folder;
    put(folder.path / "crowd.toml", crowd);
    REQUIRE(tumble_in(folder, {"run", "crowd.toml", "--out", "whole", "--quiet"}).code == 0);
    Process process(folder.path, {"run", "crowd.toml", "--quiet"});
    REQUIRE(eventually([&] { return fs::exists(folder.path / "out/crowd/frames/frame_000002.tumble"); }));
    process.send(SIGINT);
    CHECK(process.wait().code == 130);
    const Outcome without = tumble_in(folder, {"run", "out/crowd"});
    CHECK(without.code == 2);
    CHECK(contains(without.err, "out/crowd: is the folder of a run, not a scene file"));
    CHECK(contains(without.err, "`tumble run out/crowd --resume` goes on with the run"));
    CHECK(tumble_in(folder, {"run", "out/crowd", "--resume", "--out", "there"}).code == 2);
    CHECK_FALSE(fs::exists(folder.path / "there"));
    // Its own folder is no other place, however it is spelled.
    const Outcome resumed = tumble_in(folder, {"run", "out/crowd", "--resume", "--out", "out/../out/crowd/"});
    CHECK_MESSAGE(resumed.code == 0, resumed.err);
    CHECK(contains(resumed.err, ", on from t = "));
    check_same(content_of_run(folder.path / "whole"), folder.path / "out/crowd");
    CHECK(summary_in(folder.path / "out/crowd")["scene"] == "crowd.toml"); // where it came from

    CHECK(contains(tumble_in(folder, {"check", "out/crowd"}).err, "its scene is out/crowd/scene.toml"));
    CHECK(contains(tumble_in(folder, {"check", "out"}).err, "out: is a folder, not a scene file"));
}

TEST_CASE("a resume with nothing left to do says so and touches nothing; what is asked for anew is made") {
    const Folder folder;
    put(folder.path / "crowd.toml", crowd);
    REQUIRE(tumble_in(folder, {"run", "crowd.toml", "--frames", "--quiet"}).code == 0);
    const fs::path run = folder.path / "out/crowd";
    const auto when = [&](const char* name) { return fs::last_write_time(run / name); };
    const auto series = when("series.csv"), summary = when("run.json"), picture = when("pictures/frame_000001.png");
    const Outcome again = tumble_in(folder, {"run", "crowd.toml", "--resume"});
    CHECK_MESSAGE(again.code == 0, again.err);
    CHECK(contains(again.err, "nothing is left to do, and nothing was touched"));
    CHECK(when("series.csv") == series);
    CHECK(when("run.json") == summary);
    CHECK(when("pictures/frame_000001.png") == picture);
    CHECK(summary_in(run)["resumed"].empty());
    fs::remove(run / "pictures/frame_000001.png");
    CHECK(tumble_in(folder, {"run", "crowd.toml", "--resume", "--quiet"}).code == 0);
    CHECK(fs::exists(run / "pictures/frame_000001.png"));
    CHECK(tumble_in(folder, {"run", "crowd.toml", "--resume", "--dump", "--quiet"}).code == 0);
    CHECK(fs::exists(run / "spheres.dump"));
}

TEST_CASE("Ctrl-C, SIGTERM or a closed terminal while bodies are still being placed ends the run at once and leaves "
          "nothing behind") {
    const Folder folder;
    put(folder.path / "crowd.toml", crowd);
    // 37 % of the region, where random places run out at 38 %: this fill takes minutes.
    const std::vector<std::string> words{"run",   "crowd.toml",           "--threads", "1",
                                         "--set", "fill.0.count=3000000", "--set",     "body.ball.radius_mm=0.0152",
                                         "--set", "allow_large_step=true"};
    std::signal(SIGHUP, SIG_DFL); // the tests themselves may run under nohup
    for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
        Process process(folder.path, words);
        REQUIRE(eventually([&] { return process.catches(signal); }));
        process.send(signal);
        const Outcome stopped = process.wait();
        CHECK(stopped.code == code);
        CHECK(contains(stopped.err, "stopped while the scene was being built"));
        CHECK(stopped.out.empty());
        CHECK_FALSE(fs::exists(folder.path / "out"));
    }
}

TEST_CASE("the video of a resumed run is whole") {
    if (!can_check_videos())
        return;
    const Folder folder;
    put(folder.path / "crowd.toml", crowd);
    REQUIRE(tumble_in(folder, {"run", "crowd.toml", "--out", "whole", "--video", "--quiet"}).code == 0);
    Process process(folder.path, {"run", "crowd.toml", "--video", "--checkpoint-every", "0.05", "--quiet"});
    REQUIRE(eventually([&] { return fs::exists(folder.path / "out/crowd/frames/frame_000030.tumble"); }));
    process.send_to_all(SIGKILL);
    process.wait();
    const Outcome resumed = tumble_in(folder, {"run", "crowd.toml", "--resume", "--quiet"});
    CHECK_MESSAGE(resumed.code == 0, resumed.err);
    check_same(content_of_run(folder.path / "whole"), folder.path / "out/crowd");
    CHECK(probed(folder.path / "out/crowd/video.mp4", "nb_read_frames") ==
          summary_in(folder.path / "out/crowd")["frames"].dump());
}

TEST_CASE("flags that contradict each other are refused") {
    const Folder folder;
    put(folder.path / "crowd.toml", crowd);
    CHECK(tumble_in(folder, {"run", "crowd.toml", "--resume", "--force"}).code == 2);
    CHECK(tumble_in(folder, {"run", "crowd.toml", "--accept-changes"}).code == 2);
    CHECK(tumble_in(folder, {"run", "crowd.toml", "--checkpoint-every", "-1"}).code == 2);
    CHECK_FALSE(fs::exists(folder.path / "out"));
}

} // namespace test_kills
