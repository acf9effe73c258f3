#include "about.h"
#include "sim3d/sandbox.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>

namespace test_fill {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

Sandbox jar() {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.67, 0.58}, 1e-5);
    box.scene.domain.box = {{-0.05, -0.05, -0.05}, {0.05, 0.2, 0.05}};
    scene::BoxShape walls;
    walls.box = {Vector3d::Constant(-0.04), {0.04, 0.2, 0.04}};
    box.wall(walls);
    return box;
}

scene::Fill fill_of(int body, std::int64_t count) {
    scene::Fill fill;
    fill.body = body;
    fill.count = count;
    fill.region = {Vector3d::Constant(-0.05), Vector3d::Constant(0.05)};
    return fill;
}

} // namespace

TEST_CASE("before the first step the books hold the bodies with the energy that they brought, and close") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.67, 0.58}, 1e-5);
    box.scene.gravity = {0, -9.81, 0};
    const double r = 3e-3;
    box.start({placed(box.ball(r), {0, 0.1, 0}, {3, 4, 0}, {0, 0, 20}), placed(0, {0.1, -0.2, 0})});
    const Books books = books_of(*box.world);
    const double mass = 1666 * 4.0 / 3.0 * std::numbers::pi * r * r * r;
    CHECK(books.step == 0);
    CHECK(books.time == 0);
    CHECK(books.bodies == 2);
    CHECK(books.kinetic_translation == about(0.5 * mass * 25));
    CHECK(books.kinetic_rotation == about(0.5 * 0.4 * mass * r * r * 400));
    CHECK(books.gravity == about(mass * 9.81 * (0.1 - 0.2)));
    CHECK(books.inserted == about(books.kinetic_translation + books.kinetic_rotation + books.gravity));
    CHECK(std::abs(books.closure) < 1e-15 * books.kinetic_translation);
    CHECK(books.speed_max == about(5));
    CHECK(books.angular_speed_max == about(20));
    box.run(1); // the books of the first step are those of the same instant
    CHECK(books_of(*box.world).time == 0);
    CHECK(books_of(*box.world).gravity == about(books.gravity));
    CHECK(books_of(*box.world).kinetic_translation == about(books.kinetic_translation));
}

TEST_CASE("a world without bodies steps on, and its fill begins when it should") {
    Sandbox box = jar();
    box.scene.fills = {fill_of(box.ball(3e-3), 20)};
    box.scene.fills[0].start = box.scene.fills[0].until = 50e-5;
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    REQUIRE(!advance(**world, 50));
    CHECK(bodies_of(**world).empty());
    CHECK(books_of(**world).closure == 0);
    CHECK(unfilled(**world).empty()); // it owes nothing yet
    REQUIRE(!advance(**world, 2));
    CHECK(bodies_of(**world).size() == 20);
}

TEST_CASE("a fill that has begun and has placed nothing is reported, although it may go on") {
    Sandbox box = jar();
    box.scene.fills = {fill_of(box.ball(3e-3), 5)};
    box.scene.fills[0].region = {{-0.05, -0.05, -0.05}, {0.05, -0.04, 0.05}}; // below the jar
    box.scene.fills[0].until = 1;
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    REQUIRE(!advance(**world, 3));
    REQUIRE(unfilled(**world).size() == 1);
    CHECK(unfilled(**world)[0].find("placed 0") != std::string::npos);
}

TEST_CASE("a fill places what it is asked for, inside the walls, and nothing overlaps") {
    Sandbox box = jar();
    box.scene.fills = {fill_of(box.body({{{0, 0, 0}, 3e-3}, {{4e-3, 0, 0}, 2e-3}}), 150), fill_of(box.ball(3e-3), 150)};
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    CHECK(bodies_of(**world).size() == 300);
    CHECK(unfilled(**world).empty());
    REQUIRE(!advance(**world, 1));
    CHECK(books_of(**world).contacts == 0);
    CHECK(books_of(**world).overlap_max == 0);
}

TEST_CASE("random orientations are spread evenly: the first and second moments of three axes of 4000 bodies") {
    Sandbox box = jar();
    box.scene.walls.clear();
    box.scene.fills = {fill_of(box.body({{{0, 0, 0}, 3e-4}, {{4e-4, 0, 0}, 2e-4}}), 4000)};
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    // Each component of a random unit vector has mean 0 and mean square 1/3; the square has variance 1/5 - 1/9, the
    // product of two 1/15. Four standard errors.
    for (const Vector3d& axis :
         {Vector3d(Vector3d::UnitX()), Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitZ())}) {
        Vector3d mean = Vector3d::Zero(), square = Vector3d::Zero(), product = Vector3d::Zero();
        for (const BodyState& body : bodies_of(**world)) {
            const Vector3d turned = body.orientation * axis;
            mean += turned / 4000;
            square += turned.cwiseAbs2() / 4000;
            product += turned.cwiseProduct(Vector3d(turned.y(), turned.z(), turned.x())) / 4000;
        }
        CHECK(mean.cwiseAbs().maxCoeff() < 4 * std::sqrt(1.0 / 3 / 4000));
        CHECK((square - Vector3d::Constant(1.0 / 3)).cwiseAbs().maxCoeff() < 4 * std::sqrt((1.0 / 5 - 1.0 / 9) / 4000));
        CHECK(product.cwiseAbs().maxCoeff() < 4 * std::sqrt(1.0 / 15 / 4000));
    }
}

TEST_CASE("a mass is turned into the nearest number of bodies") {
    Sandbox box = jar();
    const int ball = box.ball(3e-3);
    scene::Fill fill = fill_of(ball, 1);
    fill.count.reset();
    const double one = 4.0 / 3.0 * 3.14159265358979 * 27e-9 * 1666;
    fill.mass = 40.4 * one;
    box.scene.fills = {fill};
    auto world = build_world(box.scene, 1);
    REQUIRE(world.ok());
    CHECK(bodies_of(**world).size() == 40);
}

TEST_CASE("a fill that cannot fit at once is a problem that counts what did not fit") {
    Sandbox box = jar();
    box.scene.fills = {fill_of(box.ball(10e-3), 500)};
    const auto world = build_world(box.scene, 1);
    REQUIRE(!world.ok());
    const std::string text = to_string(world.problems());
    CHECK(text.find("asked for 500 of body 'body0' (0.02 m across), placed ") != std::string::npos);
    CHECK(text.find("did not fit") != std::string::npos);
}

TEST_CASE("a fill with a body larger than its region says so, with the body's size and the place in the scene") {
    Sandbox box = jar();
    box.scene.file = "jar.toml";
    box.scene.written["fill.0"] = {"jar.toml", 17, 1};
    box.scene.fills = {fill_of(box.ball(5), 200)};
    const auto world = build_world(box.scene, 1);
    REQUIRE(!world.ok());
    CHECK(to_string(world.problems()) ==
          "jar.toml:17:1: asked for 200 of body 'body0' (10 m across), placed 0 in the region of 0.1 x 0.1 x 0.1 m; "
          "200 did not fit\n"
          "    one body alone is larger than the region: look at the unit of its size, or enlarge the region\n");
}

TEST_CASE("a fill spread over time tries again as room falls free, and tells what it still owes") {
    Sandbox box = jar();
    box.scene.gravity = {0, -9.81, 0};
    scene::Fill fill = fill_of(box.ball(5e-3), 400);
    fill.region = {{-0.04, 0.1, -0.04}, {0.04, 0.19, 0.04}};
    fill.until = 0.5;
    fill.every = 0.1;
    box.scene.fills = {fill};
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    const std::size_t first = bodies_of(**world).size();
    CHECK(first > 50);
    CHECK(first < 400);
    CHECK(unfilled(**world).size() == 1);
    auto problem = advance(**world, 25000);
    REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
    CHECK(bodies_of(**world).size() == 400);
    CHECK(unfilled(**world).empty());
}

TEST_CASE("a small body in a vast domain takes no room for the empty space around it") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.67, 0.58}, 1e-6); // 20 m wide: 1e15 cells as large as the ball
    scene::Fill fill = fill_of(box.ball(1e-4), 1);
    fill.position = {1, 2, 3};
    box.scene.fills = {fill, fill};
    box.scene.fills[1].position = {1, 2, 3.00019};
    CHECK(to_string(build_world(box.scene, 1).problems()).find("overlaps another body") != std::string::npos);
    box.scene.fills[1].position = {1, 2, 3.00021};
    CHECK(build_world(box.scene, 1).ok());
}

TEST_CASE("a stop that is wanted ends the building of a world, and a search for room as if it had not begun") {
    Sandbox box = jar();
    box.scene.fills = {fill_of(box.ball(3e-3), 50), fill_of(box.ball(2e-5), 100000000)}; // the second takes hours
    box.scene.fills[1].start = 20 * box.scene.time_step;
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

    const auto none = build_world(box.scene, 1, &stop);
    REQUIRE(!none.ok());
    CHECK(to_string(none.problems()) ==
          "stopped while the scene was being built\n    no step was taken and no file written\n");
}

TEST_CASE("a step above the stable limit is refused with the limit and what to do") {
    Sandbox box = jar();
    box.scene.allow_large_step = false;
    box.scene.time_step = 1e-2;
    box.scene.fills = {fill_of(box.ball(3e-3), 1)};
    const auto world = build_world(box.scene, 1);
    REQUIRE(!world.ok());
    CHECK(to_string(world.problems()).find("stable limit") != std::string::npos);
}

TEST_CASE("a body pushed through the wall stops the run with its number, the time and advice") {
    Sandbox box = jar();
    box.scene.walls.clear();
    box.start({placed(box.ball(3e-3), {0, 0, 0}, {0, -2, 0})});
    const auto problem = advance(*box.world, 10000);
    REQUIRE(problem);
    CHECK(problem->what.find("body 0 (body0) left the domain at y = -0.05") != std::string::npos);
    CHECK(problem->what.find("stopped at t = 0.025") != std::string::npos);
    CHECK(!problem->fix.empty());
}

TEST_CASE("spheres that sink into each other by more than a radius stop the run") {
    Sandbox box({"jelly", 1000, 1e4, 0.3}, {0.5, 0.5}, 1e-5);
    const int ball = box.ball(5e-3);
    box.start({placed(ball, {0, 0, 0}, {3, 0, 0}), placed(ball, {0.011, 0, 0}, {-3, 0, 0})});
    const auto problem = advance(*box.world, 10000);
    REQUIRE(problem);
    CHECK(problem->what.find("overlap by") != std::string::npos);
    CHECK(problem->what.find("body 0 (body0) and body 1 (body0)") != std::string::npos);
}

TEST_CASE("a body that crosses more than its radius in a step stops the run") {
    Sandbox box({"media", 1000, 1e8, 0.3}, {0.5, 0.5}, 1e-4);
    box.start({placed(box.ball(1e-3), {0, 0, 0}, {50, 0, 0})});
    const auto problem = advance(*box.world, 10);
    REQUIRE(problem);
    CHECK(problem->what.find("body 0 (body0) moves at 50 m/s") != std::string::npos);
}

TEST_CASE("a periodic box too short for a body is refused") {
    Sandbox box = jar();
    box.scene.domain.box.hi.x() = -0.045;
    box.scene.domain.periodic = {true, false, false};
    box.scene.walls.clear();
    (void)box.ball(3e-3);
    const auto world = build_world(box.scene, 1);
    REQUIRE(!world.ok());
    CHECK(to_string(world.problems()).find("its own image") != std::string::npos);
}

TEST_CASE("a body placed where another body or a wall is, is refused by name") {
    const auto refusal = [](const Vector3d& position, double start) {
        Sandbox box = jar();
        const int ball = box.ball(3e-3);
        for (const auto& [at, when] : {std::pair{Vector3d(0, 0, 0), 0.0}, std::pair{position, start}}) {
            scene::Fill fill;
            fill.body = ball;
            fill.count = 1;
            fill.position = at;
            fill.start = when;
            box.scene.fills.push_back(fill);
        }
        auto world = build_world(box.scene, 1);
        if (!world.ok())
            return to_string(world.problems());
        const auto problem = advance(**world, 200);
        return problem ? to_string(*problem) : std::string();
    };
    CHECK(refusal({0.01, 0, 0}, 0.001).empty());
    CHECK(refusal({0.001, 0, 0}, 0.001).find("overlaps another body at t = 0.001 s") != std::string::npos);
    CHECK(refusal({0.001, 0, 0}, 0).find("overlaps another body at t = 0 s") != std::string::npos);
    CHECK(refusal({-0.039, 0, 0}, 0).find("overlaps wall 'wall0'") != std::string::npos);
}

TEST_CASE("a body that is shot through a thin wall stops the run and names both") {
    Sandbox box({"media", 1666, 5e5, 0.2887}, {0.67, 0.0}, 1e-5);
    box.wall(scene::DiscShape{{0, 0, 0}, {0, 1, 0}, 0.05, 0});
    box.start({placed(box.ball(5e-3), {0, 6e-3, 0}, {0, -9, 0})});
    const auto problem = advance(*box.world, 2000);
    REQUIRE(problem);
    CHECK(problem->what.find("body 0 (body0) went through wall 'wall0'") != std::string::npos);
}

TEST_CASE("a body that has gone round the period is where it is for those that come in later") {
    // From x = 50 mm at 1 m/s around a period of 100 mm: back at 50 mm after 0.1 s, whatever the lists say.
    const auto refusal = [](double x) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, 0.3}, 1e-5);
        box.scene.domain = {{{0, -0.05, -0.05}, {0.1, 0.05, 0.05}}, {true, false, false}};
        const int ball = box.ball(5e-3);
        for (const auto& [at, when] : {std::pair{0.05, 0.0}, std::pair{x, 0.1}}) {
            scene::Fill fill;
            fill.body = ball;
            fill.count = 1;
            fill.position = Vector3d(at, 0, 0);
            fill.velocity = {1, 0, 0};
            fill.start = when;
            box.scene.fills.push_back(fill);
        }
        auto world = build_world(box.scene, 1);
        REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
        const auto problem = advance(**world, 11000);
        return problem ? to_string(*problem) : std::string();
    };
    CHECK(refusal(0.053).find("overlaps another body at t = 0.1 s") != std::string::npos);
    CHECK(refusal(0.061).empty());
}

TEST_CASE("a fill over a periodic side packs across it without overlap, off-centre bodies and bodies under way too") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, 0.3}, 1e-5);
    box.scene.domain = {{{0, -0.05, -0.02}, {0.06, 0.05, 0.02}}, {true, false, true}};
    scene::Fill fill = fill_of(box.body({{{0, 0, 0}, 4e-3}, {{7e-3, 0, 0}, 1e-3}}), 60);
    fill.region = box.scene.domain.box;
    fill.velocity = {2, 0, 0};
    scene::Fill later = fill;
    later.start = 0.02;
    box.scene.fills = {fill, later};
    auto world = build_world(box.scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    // All drift alike, so that whatever overlaps was put in so.
    const auto problem = advance(**world, 2010);
    REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
    CHECK(bodies_of(**world).size() == 120);
    CHECK(books_of(**world).contacts == 0);
}

TEST_CASE("a ball may stand beside a bucket and fall past it, but not in its sides") {
    const auto build = [](double x) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, 0.3}, 1e-5);
        box.scene.gravity = {0, -9.81, 0};
        scene::BoxShape bucket{{{-0.05, 0, -0.05}, {0.05, 0.1, 0.05}}, {}};
        bucket.open[3] = true;
        box.wall(bucket);
        scene::Fill fill;
        fill.body = box.ball(5e-3);
        fill.count = 1;
        fill.position = Vector3d(x, 0.05, 0);
        box.scene.fills = {fill};
        return build_world(box.scene, 1);
    };
    auto world = build(0.2);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    REQUIRE(!advance(**world, 20000));
    // 0.2 s of fall, leapfrog's first half kick included exactly.
    CHECK(bodies_of(**world)[0].position.y() == about(0.05 - 0.5 * 9.81 * 0.04, 1e-6));
    CHECK(build(0.056).ok());
    CHECK_FALSE(build(0.053).ok());
    CHECK_FALSE(build(0.047).ok());
}

TEST_CASE("a body that turns too far in a step for its orientation to follow stops the run by name") {
    for (const double per_step : {0.19, 0.21}) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, 0.3}, 1e-5);
        const int body = box.body({{{0, 0, 0}, 1e-3}, {{1.5e-3, 0, 0}, 1e-3}});
        box.start({placed(box.ball(1e-3), {0, 0.1, 0}), placed(body, {0.1, 0, 0}, {0, 0, 0}, {0, per_step / 1e-5, 0})});
        const auto problem = advance(*box.world, 10);
        REQUIRE(problem.has_value() == (per_step > 0.2));
        if (problem)
            CHECK(problem->what ==
                  "stopped at t = 1e-05 s, step 1: body 1 (body0) spins at 2.1e+04 rad/s, 0.21 rad in one "
                  "step where 0.2 are the most");
    }
}

TEST_CASE(
    "a clump whose spheres whirl further than a radius in a step stops the run before one can pass a wall unseen") {
    // Two spheres of 5 mm, 0.1 m either side of the middle: in 0.2 ms they go 5 mm at 250 rad/s, and turn by 0.05 rad.
    for (const double spin : {240.0, 260.0}) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, 0.3}, 2e-4);
        const int bar = box.body({{{-0.1, 0, 0}, 0.005}, {{0.1, 0, 0}, 0.005}});
        box.start({placed(bar, {0, 0, 0}, {0, 0, 0}, {0, 0, spin})});
        const auto problem = advance(*box.world, 10);
        REQUIRE(problem.has_value() == (spin > 250));
        if (problem)
            CHECK(problem->what ==
                  "stopped at t = 0.0002 s, step 1: body 0 (body0) moves at 0 m/s and spins at 260 rad/s, and "
                  "takes a sphere further than its radius in one step");
    }
}

} // namespace test_fill
