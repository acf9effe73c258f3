// The same scene of two dimensions under either solver: runs, folders, measures, what is said of it.
#include "about.h"
#include "folder.h"
#include "observe/series.h"
#include "run/run_scene.h"
#include "run/scene_check.h"
#include "scene/load.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

namespace test_hard_runs {

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double g = 9.81; // m/s2
/// Of Box2D's usual step here at the impact, over the height: what the impact's instant is known by, four times over.
constexpr double way_of_a_step = 4 * 1.98 * 2e-3 / 0.2;

/// A disc of radius 10 mm dropped from 0.2 m; restitution 0.5.
const std::string dropped_disc = R"(
title = "A disc that bounces"
dimension = 2
depth_m = 0.01
duration_s = 0.35
time_step_s = 2e-5
[domain]
lo_m = [-0.1, -0.1]
hi_m = [0.1, 0.6]
[material.glass]
density_kg_m3 = 2500
[pair.glass-glass]
restitution = 0.5
friction = 0.3
normal_stiffness_N_per_m = 1e5
stiffness_ratio = 0.7
[body.disc]
radius_mm = 10
material = "glass"
[[fill]]
body = "disc"
count = 1
position_m = [0, 0.21]
[[wall]]
name = "floor"
shape = "segment"
from_m = [-0.1, 0]
to_m = [0.1, 0]
material = "glass"
[observe]
every_s = 0.002
measures = ["centre_of_mass", "energies", "lost_energy", "energy_closure"]
[render]
every_s = 0.05
)";

scene::Scene disc(const std::vector<std::string>& sets = {}) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene_text(dropped_disc, "disc.toml", overrides);
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

struct Ran {
    Folder folder;
    run::RunSummary summary;
    observe::Series series;
    nlohmann::json json;

    explicit Ran(const scene::Scene& scene) {
        run::RunOptions options;
        options.folder = folder.path / "run";
        run::RunListener silent;
        const auto done = run::run_scene(scene, options, silent);
        REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
        summary = *done;
        REQUIRE(summary.state == "finished");
        series = observe::read_series(options.folder / "series.csv").value();
        json = nlohmann::json::parse(std::ifstream(options.folder / "run.json"));
    }
    [[nodiscard]] double last(const std::string& column) const { return series.find(column)->back(); }
};

} // namespace

TEST_CASE("solver = box2d runs the same scene in its own, longer steps; rows and frames come at the same times") {
    const Ran soft(disc()), hard(disc({"solver=box2d"}));
    CHECK(soft.json["solver"] == "soft");
    CHECK(hard.json["solver"] == "box2d");
    CHECK(hard.summary.time_step > 10 * soft.summary.time_step);
    CHECK(hard.summary.rows == soft.summary.rows);
    CHECK(hard.summary.frames == soft.summary.frames);
    // Free fall until sqrt(2 h / g) = 0.202 s, in which Euler's rule is g t dt / 2 ahead; then both come back to e^2 h.
    const auto& times = *hard.series.find("time_s");
    const auto& low = *hard.series.find("centre_of_mass_y_m");
    const auto& soft_y = *soft.series.find("centre_of_mass_y_m");
    double top = 0;
    for (std::size_t row = 0; row < times.size(); ++row) {
        if (times[row] < 0.2)
            CHECK(std::abs(low[row] - soft_y[row]) < 0.55 * g * times[row] * hard.summary.time_step + 1e-6);
        else if (times[row] > 0.25)
            top = std::max(top, low[row] - 0.01);
    }
    CHECK(top == about(0.25 * 0.2, way_of_a_step));
}

TEST_CASE("of a run of Box2D the losses are known in sum: the bounce's, as the soft run splits them") {
    const Ran soft(disc()), hard(disc({"solver=box2d"}));
    const double mass = 2500 * std::numbers::pi * 1e-4 * 0.01, bounce = (1 - 0.25) * mass * g * 0.2;
    CHECK(soft.last("lost_energy_J") == about(bounce, 0.02));
    CHECK(hard.last("lost_energy_J") == about(bounce, way_of_a_step));
    CHECK(soft.last("lost_normal_damping_J") == about(bounce, 0.02));
    for (const char* column : {"lost_normal_damping_J", "lost_sliding_J", "lost_history_J", "energy_closure_J"}) {
        CAPTURE(column);
        CHECK(std::isnan(hard.last(column)));
    }
    CHECK(hard.last("stored_normal_J") == 0);
    for (const std::string& warning : hard.summary.warnings)
        CHECK(warning.find("energy balance") == std::string::npos);
}

TEST_CASE("a run of Box2D leaves no checkpoint, and to ask for one or to resume is refused at the solver's line") {
    const Ran hard(disc({"solver=box2d", "duration_s=0.01"}));
    CHECK(hard.summary.checkpoints == 0);
    CHECK(!std::filesystem::exists(hard.folder.path / "run" / "state"));
    const auto scene = scene::load_scene_text("solver = \"box2d\"\n" + dropped_disc, "disc.toml");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    const Folder folder;
    const auto refusal = [&](const std::function<void(run::RunOptions&)>& ask) {
        run::RunOptions options;
        options.folder = folder.path / "run";
        ask(options);
        run::RunListener silent;
        const auto ran = run::run_scene(*scene, options, silent);
        REQUIRE(!ran.ok());
        CHECK(!std::filesystem::exists(options.folder));
        return to_string(ran.problems());
    };
    CHECK(refusal([](run::RunOptions& options) { options.resume = true; }) ==
          "disc.toml:1:10: a run of solver = \"box2d\" keeps no checkpoints to resume from\n"
          "    leave out --resume; --force runs it again from the start\n");
    CHECK(refusal([](run::RunOptions& options) { options.checkpoint_every = 5; }) ==
          "disc.toml:1:10: a run of solver = \"box2d\" can keep no checkpoints\n"
          "    leave out --checkpoint-every, or write solver = \"soft\"\n");
}

TEST_CASE("keys that Box2D does not read are doubted once, with the way back") {
    const auto doubts = [](const std::vector<std::string>& sets) {
        const auto check = run::check_scene(disc(sets), 1);
        REQUIRE_MESSAGE(check.ok(), to_string(check.problems()));
        std::string all;
        for (const std::string& warning : check->warnings)
            all += warning + "\n";
        return all;
    };
    CHECK(doubts({}).empty());
    CHECK(doubts({"solver=box2d"}) ==
          "--set solver: solver = \"box2d\" does not read normal_stiffness_N_per_m, stiffness_ratio: its contacts are "
          "hard, without spring or dashpot\n    docs/hard-contacts.md says what it goes by; solver = \"soft\" reads "
          "them\n");
}

TEST_CASE("Box2D's usual step is the shortest of a fall through its slop, half a radius at impact, 1/40 period") {
    // sqrt(2 * 0.005 * 0.01 / 9.81) = 3.2 ms; 0.005 m over the 2.47 m/s of a fall to the domain's bottom = 2.0 ms.
    CHECK(disc().box2d.time_step == about(2e-3));
    // Without the fall's speed gravity decides.
    CHECK(disc({"fill.0.position_m=[0, -0.05]"}).box2d.time_step == about(2e-3));
    CHECK(disc({"domain.hi_m=[0.1, 6]", "fill.0.position_m=[0, 5.9]"}).box2d.time_step == about(2e-4));
    const std::string shaken =
        "wall.floor.motion=[{kind=\"harmonic\", axis=\"y\", amplitude_m=1e-5, frequency_Hz=100}]";
    CHECK(disc({shaken}).box2d.time_step == about(2e-4)); // of 0.25 ms
    CHECK(disc({"box2d.time_step_s=3e-4"}).box2d.time_step == 3e-4);
    CHECK(disc().box2d.rebound_above == about(2 * 9.81 * 2e-3));
}

TEST_CASE("in the shipped scenes Box2D's usual step is 7 to 50 times the soft one, as docs/hard-contacts.md says") {
    double least = 1e300, most = 0;
    for (const char* name : {"repose-2d", "hopper-2d", "drum-2d", "shaken-bed-2d", "trough-2d"}) {
        const auto scene =
            scene::load_scene(std::filesystem::path(TUMBLE_ROOT) / "scenes" / (std::string(name) + ".toml"));
        REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
        least = std::min(least, scene->box2d.time_step / scene->time_step);
        most = std::max(most, scene->box2d.time_step / scene->time_step);
    }
    CHECK(least == about(7, 0.05));
    CHECK(most == about(50, 0.05));
}

TEST_CASE("a resolved scene with solver = box2d loads again to the same settings, with and without springs") {
    const scene::Scene a = disc({"solver=box2d", "box2d.velocity_iterations=7", "box2d.rebound_above_m_s=0.1"});
    const auto b = scene::load_scene_text(scene::to_toml(a), "again.toml");
    REQUIRE_MESSAGE(b.ok(), to_string(b.problems()));
    CHECK(b->solver == scene::Solver::box2d);
    CHECK(b->box2d.time_step == a.box2d.time_step);
    CHECK(b->box2d.velocity_iterations == 7);
    CHECK(b->box2d.position_iterations == a.box2d.position_iterations);
    CHECK(b->box2d.rebound_above == 0.1);

    std::string springless = dropped_disc;
    for (const char* line : {"normal_stiffness_N_per_m = 1e5\n", "stiffness_ratio = 0.7\n"})
        springless.erase(springless.find(line), std::string(line).size());
    const auto hard = scene::load_scene_text("solver = \"box2d\"\n" + springless, "hard.toml");
    REQUIRE_MESSAGE(hard.ok(), to_string(hard.problems()));
    const auto twice = scene::load_scene_text(scene::to_toml(*hard), "twice.toml");
    REQUIRE_MESSAGE(twice.ok(), to_string(twice.problems()));
    CHECK(twice->pairs[0].restitution == 0.5);
    CHECK(!scene::load_scene_text(springless, "soft.toml").ok());
}

} // namespace test_hard_runs
