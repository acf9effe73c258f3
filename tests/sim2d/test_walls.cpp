#include "about.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_walls {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

} // namespace

TEST_CASE("rolling over joints of a straight floor shows no jump in force") {
    const auto rolled = [](const scene::PolylineShape& floor) {
        Sandbox box(springs(1e6, 1, 0.5, 0.5), 1e-4);
        box.scene.gravity = {2, -9.81, 0};
        box.wall(floor);
        const int disc = box.disc(0.1);
        box.put({at(disc, {0, 0.1})});
        box.step(20000);
        return box.body_at(0);
    };
    scene::PolylineShape joined;
    for (int k = -10; k <= 60; ++k)
        joined.points.emplace_back(0.1 * k, 0);
    const BodyState plain = rolled({{{-1, 0}, {6, 0}}, false}), over = rolled(joined);
    CHECK(plain.position.x() > 2.5);
    CHECK(over.position.x() == about(plain.position.x(), 1e-9));
    CHECK(over.velocity.x() == about(plain.velocity.x(), 1e-9));
    CHECK(over.position.y() == about(plain.position.y(), 1e-9));
}

namespace {

/// A disc of radius 0.1 m after 4 s in a drum of radius 1 m that turns with 2 rad/s, in air that damps with 5 1/s.
BodyState in_a_drum(double friction) {
    Sandbox box(springs(1e6, 1, 0.3, friction), 1e-4);
    box.wall(scene::ArcShape{{0, 0}, 1, 0, 2 * pi}).motion.rotations = {{{}, {0, 0, 0}, {0, 0, 1}, 2.0}};
    const int disc = box.disc(0.1);
    box.scene.gravity = {0, -9.81, 0};
    box.scene.contact.global_damping = 5;
    box.put({at(disc, {0, -0.9})});
    box.step(40000);
    return box.body_at(0);
}

} // namespace

TEST_CASE("a disc in a turning drum rolls where its damping's moment is gravity's, and slides where friction ends") {
    // Its centre at rest, the disc turns with the wall: w = 2 * 1 / 0.1 = 20 rad/s. Damping takes the moment
    // a (m r^2 / 2) w, so friction is a m r w / 2 = 5 m, which gravity holds at sin(angle) = 5 / g up the wall, where
    // it takes a friction of tan(angle) = 0.59. An overlap of 0.26 mm changes arm, spin and angle by up to 0.3 %.
    const BodyState rolls = in_a_drum(0.8);
    CHECK(rolls.velocity.norm() < 1e-3);
    CHECK(rolls.angular_velocity == about(20, 4e-3));
    CHECK(std::atan2(rolls.position.x(), -rolls.position.y()) == about(std::asin(5 / 9.81), 4e-3));
    // With less it slides at atan(mu), and turns with 2 g sin(angle) / (a r).
    const double angle = std::atan(0.4);
    const BodyState slides = in_a_drum(0.4);
    CHECK(std::atan2(slides.position.x(), -slides.position.y()) == about(angle, 4e-3));
    CHECK(slides.angular_velocity == about(2 * 9.81 * std::sin(angle) / 0.5, 4e-3));
}

TEST_CASE("a disc that is pressed through a wall stops the run, with its name and the time") {
    Sandbox box(springs(1e3, 1, 1, 0), 1e-3);
    box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
    const int disc = box.disc(0.1);
    box.put({at(disc, {0, 0.2}, {0, -60})});
    const auto problem = advance(*box.world, 100);
    REQUIRE(problem);
    CHECK(problem->what.find("body 0 (body0)") != std::string::npos);
    CHECK(problem->what.find("went through wall 'wall0'") != std::string::npos);
    CHECK(problem->what.find("stopped at t = ") != std::string::npos);
}

TEST_CASE("a clump whose discs whirl further than a radius in a step stops the run before one can pass a wall unseen") {
    // Two discs of 5 mm, 0.1 m either side of the middle: in 0.2 ms they go 0.02 mm at 1 rad/s, 5 mm at 250 rad/s.
    const auto spun = [](double spin) {
        Sandbox box(springs(1e5, 1, 1, 0), 2e-4);
        box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
        const int bar = box.body({{{-0.1, 0, 0}, 0.005}, {{0.1, 0, 0}, 0.005}});
        BodyState body = at(bar, {0, 0.2});
        body.angular_velocity = spin;
        box.put({body});
        const auto problem = advance(*box.world, 5);
        return problem ? problem->what : "";
    };
    CHECK(spun(240).empty());
    CHECK(spun(260).find("spins at 260 rad/s: its discs go further than the smallest one's radius in one step") !=
          std::string::npos);
}

TEST_CASE(
    "a wall that could pass a whole disc within one step stops the run, though they touch neither before nor after") {
    const auto goes = [](double speed) {
        Sandbox box(springs(1e3, 1, 1, 0), 1e-3);
        box.wall(scene::SegmentShape{{-1, 0.35}, {1, 0.35}}).motion.linears = {{{}, {0, speed, 0}}};
        box.put({at(box.disc(0.1), {0, 0.1})});
        const auto problem = advance(*box.world, 2); // walls move from the second step on
        return problem ? problem->what : "";
    };
    CHECK(goes(-500).find("wall 'wall0' moves by 0.5 m in one step, more than the smallest disc's radius") !=
          std::string::npos); // from 0.15 m above the disc to 0.15 m below it
    CHECK(goes(-95).empty()); // 0.095 m
}

TEST_CASE("a disc whose centre passes a wall where two pieces meet stops the run too") {
    // So soft that the disc flies straight on: from `before` to `after` in one step, past the joint in the middle.
    const auto passes = [](const scene::Outline& outline, const Vector2d& before, const Vector2d& after) {
        const double dt = 1e-3;
        Sandbox box(springs(1e-3, 1, 1, 0), dt);
        box.wall(outline);
        const Vector2d way = after - before;
        // Nine steps ahead, so that it touches before it passes.
        box.put({at(box.disc(0.1), before - 9 * way, way / dt)});
        const auto problem = advance(*box.world, 12);
        return problem && problem->what.find("went through wall 'wall0'") != std::string::npos;
    };
    const scene::PolylineShape peak{{{-1, -1}, {0, 0}, {1, -1}}, false};
    CHECK(passes(peak, {0, 0.002}, {0, -0.002}));
    CHECK(passes(peak, {0, -0.002}, {0, 0.002}));
    CHECK(passes(peak, {0.003, 0.0005}, {-0.001, -0.003}));
    CHECK(!passes(peak, {-0.003, 0.001}, {0.003, 0.001}));
    // A floor in two pieces: the disc leaves one above it and meets the other below.
    const scene::PolylineShape floor{{{-1, 0}, {0, 0}, {1, 0.1}}, false};
    CHECK(passes(floor, {-0.004, 0.001}, {0.004, -0.002}));
    CHECK(!passes(floor, {-0.004, 0.003}, {0.004, 0.003}));
    // Round the end of a wall, and through the end of an arc.
    const scene::SegmentShape edge{{-1, 0}, {0, 0}};
    CHECK(!passes(edge, {0.001, 0.004}, {0.003, -0.004}));
    CHECK(passes(edge, {-0.003, 0.004}, {-0.001, -0.004}));
    const scene::ArcShape quarter{{0, -1}, 1, 0, pi / 2};
    CHECK(passes(quarter, {0.002, 0.002}, {0.001, -0.002}));
    CHECK(!passes(quarter, {-0.001, 0.002}, {-0.002, -0.002}));
}

} // namespace test_walls
