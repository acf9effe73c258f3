#include "about.h"
#include "sandbox.h"
#include "sim2d/wall_line.h"

#include <cmath>
#include <numbers>

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

std::vector<WallTouch> touches_of(const scene::Outline& outline, const Vector2d& centre, double radius,
                                  const scene::Domain& domain = {}) {
    const WallLine line(outline, domain);
    std::vector<int> pieces;
    line.pieces_near(centre, radius, pieces);
    std::vector<WallTouch> touches(max_wall_touches);
    touches.resize(static_cast<std::size_t>(line.touches(centre, radius, pieces, touches)));
    return touches;
}

} // namespace

TEST_CASE("a segment is touched from both sides and on its ends, each once") {
    const scene::SegmentShape floor{{0, 0}, {1, 0}};
    const auto above = touches_of(floor, {0.3, 0.09}, 0.1);
    REQUIRE(above.size() == 1);
    CHECK(above[0].normal.y() == about(1));
    CHECK(above[0].gap == about(-0.01));
    CHECK(touches_of(floor, {0.3, -0.09}, 0.1)[0].normal.y() == about(-1));
    const auto end = touches_of(floor, {1.06, 0.06}, 0.1);
    REQUIRE(end.size() == 1);
    CHECK(end[0].normal.x() == about(std::sqrt(0.5)));
    CHECK(touches_of(floor, {0.3, 0.11}, 0.1).empty());
}

TEST_CASE("a corner is one touch from outside and two from inside") {
    const scene::PolylineShape corner{{{-1, 0}, {0, 0}, {0, -1}}, false};
    CHECK(touches_of(corner, {0.05, 0.05}, 0.1).size() == 1);
    CHECK(touches_of(corner, {-0.05, -0.05}, 0.1).size() == 2);
    CHECK(touches_of(corner, {-0.02, 0.05}, 0.1).size() == 1);
}

TEST_CASE("a circle is touched from inside and outside, a part of it also on its ends") {
    const scene::ArcShape circle{{0, 0}, 1, 0, 2 * pi};
    CHECK(touches_of(circle, {0.95, 0}, 0.1)[0].normal.x() == about(-1));
    CHECK(touches_of(circle, {1.05, 0}, 0.1)[0].normal.x() == about(1));
    const scene::ArcShape quarter{{0, 0}, 1, 0, pi / 2};
    const auto end = touches_of(quarter, {1, -0.05}, 0.1);
    REQUIRE(end.size() == 1);
    CHECK(end[0].normal.y() == about(-1));
    CHECK(touches_of(quarter, {-0.95, 0}, 0.1).empty());
}

TEST_CASE("a trough is its three pieces, and its joints are not felt") {
    scene::TroughShape trough;
    trough.radius = 0.5;
    trough.rim = 1.5;
    for (const double y : {0.49, 0.5, 0.51}) {
        const auto touch = touches_of(trough, {0.41, y}, 0.1);
        REQUIRE(touch.size() == 1);
        CHECK(touch[0].gap == about(-0.01, 0.02));
    }
}

TEST_CASE("along a periodic direction a floor goes on through the domain's ends") {
    scene::Domain domain;
    domain.box = {{0, -1, -0.5}, {2, 1, 0.5}};
    domain.periodic = {true, false, false};
    for (const double x : {-0.05, 0.0, 0.05, 1.95, 2.05}) {
        const auto touch = touches_of(scene::SegmentShape{{0, 0}, {2, 0}}, {x, 0.09}, 0.1, domain);
        REQUIRE(touch.size() == 1);
        CHECK(touch[0].normal.y() == about(1));
    }
}

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

TEST_CASE("a disc in a turning drum with friction enough comes to roll with it") {
    Sandbox box(springs(1e6, 1, 0.3, 0.8), 1e-4);
    box.wall(scene::ArcShape{{0, 0}, 1, 0, 2 * pi}).motion.rotations = {{{}, {0, 0, 0}, {0, 0, 1}, 2.0}};
    const int disc = box.disc(0.1);
    box.scene.gravity = {0, -9.81, 0};
    box.scene.contact.global_damping = 5;
    box.put({at(disc, {0, -0.9})});
    box.step(40000);
    // At the lowest point the wall moves along +x at 2 m/s; held there by gravity and damping the disc spins with it.
    const BodyState end = box.body_at(0);
    CHECK(std::abs(end.velocity.norm()) < 0.05);
    CHECK(end.angular_velocity > 0);
}

TEST_CASE("a disc that is pressed through a wall stops the run, with its name and the time") {
    Sandbox box(springs(1e3, 1, 1, 0), 1e-3);
    box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
    const int disc = box.disc(0.1);
    box.put({at(disc, {0, 0.2}, {0, -60})});
    const auto problem = advance(*box.world, 100);
    REQUIRE(problem);
    CHECK(problem->what.find("body 0 (body0)") != std::string::npos);
    CHECK(problem->what.find("stopped at t = ") != std::string::npos);
}
