#include "about.h"
#include "discs/wall_line.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_wall_line {

using namespace tumble;
using namespace tumble::discs;
using Eigen::Vector2d;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2 * pi;

std::vector<WallTouch> touches_of(const scene::Outline& outline, const Vector2d& centre, double radius,
                                  const scene::Domain& domain = {}) {
    const WallLine line(outline, domain);
    std::vector<int> pieces;
    line.pieces_near(centre, radius, pieces);
    std::vector<WallTouch> touches(4);
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

TEST_CASE("walls with an open end have no inside") {
    const scene::Domain domain{{{-5, -5, -1}, {5, 5, 1}}, {false, false, false}};
    CHECK(WallLine(scene::ArcShape{{0, 0}, 1, 0, turn}, domain).closed());
    CHECK(WallLine(scene::BoxShape{{{-1, -1, 0}, {1, 1, 0}}, {}}, domain).closed());
    CHECK(!WallLine(scene::ArcShape{{0, 0}, 1, 0, 0.9 * turn}, domain).closed());
    CHECK(!WallLine(scene::PolylineShape{{{0, 0}, {1, 0}, {1, 1}}, false}, domain).closed());
    const WallLine ring(scene::ArcShape{{0, 0}, 1, 0, turn}, domain);
    CHECK(ring.encloses({0.7, -0.7}));
    CHECK(!ring.encloses({0.72, -0.72}));
    CHECK(!WallLine(scene::SegmentShape{{-1, 0}, {1, 0}}, domain).encloses({0, 0}));
}

} // namespace test_wall_line
