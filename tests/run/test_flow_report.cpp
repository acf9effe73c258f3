#include "about.h"
#include "folder.h"
#include "observe/series.h"
#include "run/flow_report.h"
#include "run/run_scene.h"
#include "scene/load.h"

#include <cstdlib>
#include <doctest/doctest.h>
#include <numbers>

namespace test_flow_report {

using namespace tumble;
using tumble::test::about;

namespace {

/// Two balls tied to nothing: one goes straight, the other falls and bounces on a plate.
const std::string two_balls = R"(
duration_s = 0.9
time_step_s = 1e-4
gravity_m_s2 = [0, -9.81, 0]
[domain]
lo_m = [-0.5, -0.1, -0.5]
hi_m = [0.5, 0.5, 0.5]
[material.soft]
density_kg_m3 = 1000
youngs_modulus_Pa = 1e6
poisson_ratio = 0.3
[pair.soft-soft]
restitution = 1
friction = 0
[body.heavy]
radius_m = 0.02
material = "soft"
[body.bouncer]
radius_m = 0.01
material = "soft"
tracer_point_m = [0.005, 0, 0]
[[fill]]
body = "heavy"
count = 1
position_m = [-0.2, 0.02, 0]
velocity_m_s = [0.2, 0, 0]
[[fill]]
body = "bouncer"
count = 1
position_m = [0.1, 0.06, 0.2]
orientation = "as_written"
[[wall]]
name = "plate"
shape = "plane"
point_m = [0, 0, 0]
material = "soft"
[observe]
every_s = 0.005
measures = ["bodies", "tracer:bouncer"]
[render]
every_s = 0.005
)";

scene::Scene scene_of(const std::string& text) {
    auto scene = scene::load_scene_text(text, "two-balls.toml");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

} // namespace

TEST_CASE("a bouncing ball's cycle is two free falls, in the frames and in its tracer's columns") {
    const test::Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "run";
    run::RunListener silent;
    const auto done = run::run_scene(scene_of(two_balls), options, silent);
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));

    run::FlowOptions flow;
    flow.bodies = {"bouncer"};
    flow.grid.rings = 3;
    flow.grid.layers = 4;
    flow.fit_radius = flow.fit_heights = true;
    const auto report = run::read_flow(options.folder, flow, [](std::int64_t, std::int64_t) {});
    REQUIRE_MESSAGE(report.ok(), to_string(report.problems()));
    // Dropped by 50 mm: 2 sqrt(2 h / g) = 0.202 s from top to top, and 4 ms of the soft contact.
    const observe::Cycle cycle = report->paths[0].cycle();
    CHECK(cycle.period == about(2 * std::sqrt(2 * 0.05 / 9.81), 0.06));
    CHECK(cycle.peak_to_peak == about(0.05, 0.06));
    CHECK(report->kinetic.front() == about(0.5 * 1000 * 4 * std::numbers::pi / 3 * 8e-6 * 0.04));

    const auto series = observe::read_series(options.folder / "series.csv").value();
    const auto* height = series.find("tracer:bouncer_y");
    const auto* time = series.find("time");
    REQUIRE(height != nullptr);
    CHECK(observe::find_cycle(*time, *height).period == about(cycle.period, 1e-9));
    // In flight nothing is felt, on the plate a push upwards.
    const auto* felt = series.find("tracer:bouncer_felt_y");
    REQUIRE(felt != nullptr);
    CHECK(std::abs((*felt)[10]) < 1e-3);
    CHECK(*std::max_element(felt->begin() + 1, felt->end()) > 50);
    CHECK(run::write_flow(*report, folder.path / "tables").value().size() == 4);
}

TEST_CASE("the picture of a flow says what its colours and arrows are, with units" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const test::Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "run";
    run::RunListener nobody;
    REQUIRE(run::run_scene(scene_of(two_balls), options, nobody));
    run::FlowOptions flow;
    flow.grid = {.axis_x = 0, .axis_z = 0, .radius = 0.4, .lo = 0, .hi = 0.1, .rings = 4, .layers = 2};
    const auto report = run::read_flow(options.folder, flow, [](std::int64_t, std::int64_t) {});
    REQUIRE_MESSAGE(report.ok(), to_string(report.problems()));
    REQUIRE(run::draw_flow(*report, folder.path / "flow.svg").ok());
    const std::string drawn = test::content_of(folder.path / "flow.svg");
    CHECK(drawn.find("tangential velocity [m/s]") != std::string::npos);
    CHECK(drawn.find("radial and vertical velocity, 60 mm are ") != std::string::npos); // 1.2 layers of 50 mm
    // The arrow beside these words is as long in the axes' own unit, and gnuplot's own sample of arrows is left out.
    const std::string script = run::flow_script(*report, folder.path / "flow.svg", run::flow_canvas);
    CHECK(script.find("rto first 60,first 0 filled head") != std::string::npos);
    CHECK(script.find("with vectors filled head size graph 0.008,20 lw 1.6 lc rgb '#000000' notitle") !=
          std::string::npos);
}

TEST_CASE("a flow about an axis that no body comes near is refused with where it was looked for") {
    const test::Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "run";
    run::RunListener nobody;
    REQUIRE(run::run_scene(scene_of(two_balls), options, nobody));
    run::FlowOptions beside;
    beside.grid = {.axis_x = 5, .axis_z = 5, .radius = 0.1665, .lo = 0, .hi = 0.16, .rings = 5, .layers = 4};
    const auto read = run::read_flow(options.folder, beside, [](std::int64_t, std::int64_t) {});
    REQUIRE_FALSE(read);
    CHECK(read.problems().front().what ==
          "no body came within 0.1665 m of the axis x = 5 m, z = 5 m at heights of 0 to 0.16 m");
}

TEST_CASE("a tracer of a body that is not there is refused where it is written, with the nearest name") {
    std::string text = two_balls;
    text.replace(text.find("tracer:bouncer"), 14, "tracer:bounzer");
    const test::Folder folder;
    run::RunOptions options;
    options.folder = folder.path / "run";
    run::RunListener silent;
    const auto done = run::run_scene(scene_of(text), options, silent);
    REQUIRE(!done.ok());
    CHECK(done.problems()[0].what == "there is no body 'bounzer' to trace");
    CHECK(done.problems()[0].fix == "did you mean 'bouncer'?");
    CHECK(done.problems()[0].line > 0);
}

} // namespace test_flow_report
