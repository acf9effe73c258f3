// What fills put in, and where. A closed wall has two sides: a region that reaches through it fills the one it mostly
// lies on.
#include "sandbox.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

namespace test_fill {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;

namespace {

Sandbox box_of_20_m(bool periodic) {
    Sandbox box(springs(1e5, 0.5, 0.9, 0.4), 1e-3);
    box.scene.domain.box = {{0, 0, -0.5}, {20, 20, 0.5}};
    box.scene.domain.periodic = {periodic, false, false};
    return box;
}

scene::Fill one_at(int body, const Vector2d& position) {
    scene::Fill fill;
    fill.body = body;
    fill.count = 1;
    fill.position = {position.x(), position.y(), 0};
    fill.orientation = scene::Orientation::as_written;
    return fill;
}

scene::Fill many_in(const scene::Box& region, int body, int count) {
    scene::Fill fill;
    fill.body = body;
    fill.count = count;
    fill.region = region;
    return fill;
}

std::string refusal(Sandbox& box) {
    const auto built = build_world(box.scene, 1);
    return built.ok() ? std::string() : to_string(built.problems());
}

/// 60 discs of radius 0.05 m at random in |x|, |y| <= half (m).
scene::Fill square(double half, int body) {
    scene::Fill fill;
    fill.body = body;
    fill.count = 60;
    fill.region = {{-half, -half, -0.5}, {half, half, 0.5}};
    return fill;
}

constexpr double turn = 2 * std::numbers::pi;

} // namespace

TEST_CASE("a world without discs steps on, and its fill begins when it should") {
    Sandbox box({0.67, 0.58}, 1e-5);
    box.scene.domain.box = {{-0.1, -0.1, 0}, {0.1, 0.1, 0}};
    box.scene.fills = {square(0.05, box.disc(3e-3))};
    box.scene.fills[0].start = box.scene.fills[0].until = 50e-5;
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    REQUIRE(!advance(**world, 50));
    CHECK(bodies_of(**world).empty());
    CHECK(unfilled(**world).empty()); // it owes nothing yet
    REQUIRE(!advance(**world, 2));
    CHECK(bodies_of(**world).size() == 60);
}

TEST_CASE("a fill places what it is asked for, inside the walls, and nothing overlaps") {
    Sandbox box = box_of_20_m(false);
    scene::BoxShape walls;
    walls.box = {{5, 5, -0.5}, {15, 15, 0.5}};
    box.wall(walls);
    const int disc = box.disc(0.3), pair = box.body({{{0, 0, 0}, 0.3}, {{0.4, 0, 0}, 0.2}});
    box.scene.fills = {many_in({{0, 0, -0.5}, {20, 20, 0.5}}, pair, 60),
                       many_in({{5, 5, -0.5}, {15, 15, 0.5}}, disc, 40)};
    box.build();
    CHECK(bodies_of(*box.world).size() == 100);
    CHECK(unfilled(*box.world).empty());
    box.step();
    CHECK(books_of(*box.world).contacts == 0);
    CHECK(books_of(*box.world).overlap_max == 0);
}

TEST_CASE("a body that sticks out through a periodic side takes the room that it comes out into") {
    // The rod's third disc stands at 19.9 + 1.2 = 21.1, seen again at 1.1: it takes the room from there to 2.1.
    for (const auto& [x, free] : {std::pair{2.5, false}, {3.05, false}, {3.15, true}}) {
        CAPTURE(x);
        Sandbox box = box_of_20_m(true);
        const int rod = box.body({{{-1.2, 0, 0}, 1}, {{0, 0, 0}, 1}, {{1.2, 0, 0}, 1}});
        const int disc = box.disc(1);
        box.scene.fills = {one_at(rod, {19.9, 10}), one_at(disc, {x, 10})};
        CHECK(refusal(box).empty() == free);
        std::swap(box.scene.fills[0], box.scene.fills[1]);
        CHECK(refusal(box).empty() == free);
    }
}

TEST_CASE("a crowd of rods in a box that repeats is placed without a single overlap") {
    Sandbox box = box_of_20_m(true);
    box.scene.domain.periodic = {true, true, false};
    const int rod = box.body({{{-1.2, 0, 0}, 0.7}, {{0, 0, 0}, 0.7}, {{1.2, 0, 0}, 0.7}});
    box.scene.fills = {many_in(box.scene.domain.box, rod, 22)};
    box.build();
    box.step();
    CHECK(books_of(*box.world).bodies == 22);
    CHECK(books_of(*box.world).contacts == 0);
}

TEST_CASE("a mass is turned into the nearest number of bodies") {
    Sandbox box = box_of_20_m(false);
    scene::Fill fill = many_in(box.scene.domain.box, box.disc(0.1), 1);
    fill.count.reset();
    fill.mass = 40.4 * 1000 * 3.14159265358979 * 0.01;
    box.scene.fills = {fill};
    box.build();
    CHECK(bodies_of(*box.world).size() == 40);
}

TEST_CASE("a fill that cannot fit says at its line how many it could not place, and what to do") {
    Sandbox box = box_of_20_m(false);
    box.scene.file = "hopper.toml";
    box.scene.written["fill.1"] = {"hopper.toml", 17, 1};
    const int disc = box.disc(1);
    box.scene.fills = {many_in({{0, 0, -0.5}, {20, 2.5, 0.5}}, disc, 1),
                       many_in({{0, 10, -0.5}, {2.5, 12.5, 0.5}}, disc, 3)};
    CHECK(refusal(box) ==
          "hopper.toml:17:1: asked for 3 of body 'body0', placed 1 in the region of 2.5 x 2.5 m; 2 did not fit\n"
          "    enlarge the region, ask for fewer, or give until_s so that bodies come in over time\n");
}

TEST_CASE("a body placed where another body or a wall is, is refused at its line") {
    const auto refused = [](const Vector2d& position) {
        Sandbox box = box_of_20_m(false);
        box.scene.written["fill.1.position_m"] = {"two.toml", 9, 3};
        box.wall(scene::SegmentShape{{0, 5}, {20, 5}});
        const int disc = box.disc(1);
        box.scene.fills = {one_at(disc, {10, 10}), one_at(disc, position)};
        return refusal(box);
    };
    CHECK(refused({12.1, 10}).empty());
    CHECK(refused({11, 10}).find("two.toml:9:3: body 'body0' at (11, 10) m overlaps another body at t = 0 s") == 0);
    CHECK(refused({4, 5.5}).find("two.toml:9:3: body 'body0' at (4, 5.5) m overlaps wall 'wall0' at t = 0 s") == 0);
}

TEST_CASE("a small disc in a vast domain takes no room for the empty space around it") {
    Sandbox box = box_of_20_m(false); // 4e10 cells as large as the disc
    const int disc = box.disc(5e-5);
    box.scene.fills = {one_at(disc, {1, 2}), one_at(disc, {1, 2.000099})};
    CHECK(refusal(box).find("overlaps another body") != std::string::npos);
    box.scene.fills[1].position = {1, 2.000101, 0};
    CHECK(refusal(box).empty());
}

TEST_CASE("a stop that is wanted ends the building of a world, and a search for room as if it had not begun") {
    Sandbox box = box_of_20_m(false);
    const int large = box.disc(0.3), small = box.disc(2e-4);
    box.scene.fills = {many_in(box.scene.domain.box, large, 50), many_in(box.scene.domain.box, small, 100000000)};
    box.scene.fills[1].start = 20 * box.scene.time_step; // takes hours
    std::atomic<bool> stop{false};
    auto world = build_world(box.scene, 1, &stop);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    REQUIRE(!advance(**world, 20));
    const std::string before = state_of(**world);
    std::jthread soon([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stop = true;
    });
    CHECK(!advance(**world, 100));
    CHECK(steps_of(**world) == 20);
    CHECK(bodies_of(**world).size() == 50);
    CHECK(state_of(**world) == before);
    CHECK(to_string(build_world(box.scene, 1, &stop).problems()) ==
          "stopped while the scene was being built\n    no step was taken and no file written\n");
}

TEST_CASE("a square region about a round drum fills the drum, and nothing comes in behind its wall") {
    Sandbox box(springs(1e5, 1, 1, 0), 1e-4);
    box.wall(scene::ArcShape{{0, 0}, 1, 0, turn});
    box.scene.fills = {square(1, box.disc(0.05))};
    box.build();
    REQUIRE(bodies_of(*box.world).size() == 60);
    for (const BodyState& body : bodies_of(*box.world))
        CHECK(body.position.norm() <= 0.95);
}

TEST_CASE(
    "a small closed wall inside of a region is an obstacle, wherever it has moved to: nothing comes in inside of it") {
    for (const double shift : {0.0, 0.3}) {
        CAPTURE(shift);
        Sandbox box(springs(1e5, 1, 1, 0), 1e-4);
        const double half = 0.4;
        scene::Wall& block =
            box.wall(scene::PolylineShape{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true});
        block.motion.linears = {{{}, {shift / 0.01, 0, 0}}};
        box.scene.fills = {square(1, box.disc(0.05))};
        box.scene.fills[0].start = box.scene.fills[0].until = 0.01;
        box.build();
        box.step(101);
        REQUIRE(bodies_of(*box.world).size() == 60);
        for (const BodyState& body : bodies_of(*box.world))
            CHECK((body.position - Vector2d(shift, 0)).cwiseAbs().maxCoeff() > half);
    }
}

} // namespace test_fill
