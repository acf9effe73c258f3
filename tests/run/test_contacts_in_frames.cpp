#include "../folder.h"
#include "about.h"
#include "observe/frame_file.h"
#include "run/redraw.h"
#include "run/run_scene.h"
#include "scenes.h"

#include <doctest/doctest.h>

namespace test_contacts_in_frames {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// Two discs on a floor, apart from each other and each against a wall, and one on top of both.
const std::string pyramid = R"(
title = "Three discs at rest"
claim = "each is borne by what it touches"
dimension = 2
depth_m = 0.01
duration_s = 0.6
time_step_s = 2e-5
[domain]
lo_m = [-0.1, -0.1]
hi_m = [0.1, 0.1]
[material.glass]
density_kg_m3 = 2500
[pair.glass-glass]
restitution = 0.1
friction = 0.1 # little enough that they lean on the walls
normal_stiffness_N_per_m = 1e5
stiffness_ratio = 0.7
[body.disc]
radius_mm = 10
material = "glass"
[[fill]]
body = "disc"
count = 1
position_m = [-0.0119999, 0.0100001]
[[fill]]
body = "disc"
count = 1
position_m = [0.0119999, 0.0100001]
[[fill]]
body = "disc"
count = 1
position_m = [0.0, 0.027]
[[wall]]
name = "trough"
shape = "polyline"
points_m = [[-0.022, 0.08], [-0.022, 0.0], [0.022, 0.0], [0.022, 0.08]]
material = "glass"
[observe]
contacts = true
[render]
every_s = 0.3
width_px = 320
height_px = 240
force_chains = true
)";

fs::path ran(const scene::Scene& scene, const fs::path& folder) {
    run::RunOptions options;
    options.folder = folder;
    run::RunListener silent;
    const auto summary = run::run_scene(scene, options, silent);
    REQUIRE_MESSAGE(summary.ok(), to_string(summary.problems()));
    REQUIRE(summary->state == "finished");
    return folder;
}

observe::Frame last_frame(const fs::path& run) {
    const auto layout = observe::read_layout(observe::layout_path(run / "frames"));
    REQUIRE(layout.ok());
    const auto frame = observe::read_frame(observe::list_frames(run / "frames").back(), *layout);
    REQUIRE_MESSAGE(frame.ok(), to_string(frame.problems()));
    return *frame;
}

} // namespace

TEST_CASE("the contacts in a frame bear each resting body's weight, pair by pair and wall by wall") {
    const Folder folder;
    const observe::Frame frame = last_frame(ran(loaded(pyramid), folder.path / "pyramid"));
    REQUIRE(frame.contacts);
    // The lower two stand on the floor, lean on a wall each, and both bear the upper one.
    CHECK(frame.contacts->size() == 6);
    std::vector<Eigen::Vector3d> forces(3, Eigen::Vector3d::Zero());
    for (const observe::FrameContact& contact : *frame.contacts) {
        CHECK(contact.pressing() > 0);
        forces[static_cast<std::size_t>(contact.a)] += contact.force;
        if (contact.b >= 0)
            forces[static_cast<std::size_t>(contact.b)] -= contact.force;
    }
    const double weight = frame.layout->shapes[0].mass * 9.81;
    for (const Eigen::Vector3d& force : forces)
        CHECK((force - Eigen::Vector3d(0, weight, 0)).norm() < 1e-4 * weight);
}

TEST_CASE("frames have contacts only where the scene asks for them, and force chains of none are a problem") {
    const Folder folder;
    scene::Scene scene = loaded(falling_ball);
    const fs::path run = ran(scene, folder.path / "ball");
    CHECK(!last_frame(run).contacts);
    run::RedrawOptions options;
    options.settings = scene.render;
    options.settings.marks.chains = true;
    options.targets.folder = folder.path / "drawn";
    const auto silent = [](std::int64_t, std::int64_t) {};
    const Problems problems = run::redraw(run, options, silent).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].key == "render.force_chains");
    scene.observe.contacts = true;
    const fs::path again = ran(scene, folder.path / "again");
    REQUIRE(last_frame(again).contacts);
    CHECK(last_frame(again).contacts->empty()); // it falls
}

TEST_CASE("all pictures of a run that is redrawn have one scale of arrows") {
    // From 0.5 m the ball falls 0.02 s: of its speeds in five frames, 0 to 0.196 m/s, the largest is rounded up.
    const Folder folder;
    const fs::path run = ran(loaded(falling_ball), folder.path / "ball");
    const auto recording = run::open_recording(run, {});
    REQUIRE(recording.ok());
    scene::Marks marks;
    marks.arrows = "bodies";
    CHECK(*run::marks_for({&*recording, 1}, marks)->arrow_speed == about(0.2));
    marks.arrow_speed = 3;
    CHECK(run::marks_for({&*recording, 1}, marks)->arrow_speed == 3);
}

} // namespace test_contacts_in_frames
