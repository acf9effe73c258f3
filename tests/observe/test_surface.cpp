#include "about.h"
#include "frames.h"
#include "observe/surface.h"

#include <doctest/doctest.h>
#include <numbers>

namespace test_surface {

using namespace tumble;
using namespace tumble::test;

namespace {

double tangent(double degrees) {
    return std::tan(degrees * std::numbers::pi / 180);
}

/// Columns of balls, 5 mm in radius and 10 mm apart, whose topmost centres lie on y = height(z).
template <class Height> observe::Frame heap(Height height) {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.005, 1e-3));
    for (int k = -20; k <= 20; ++k)
        for (double y = height(0.01 * k); y > -0.2; y -= 0.01)
            for (int i = 0; i < 3; ++i)
                add_body(frame, {0.01 * i, y, 0.01 * k});
    return frame;
}

} // namespace

TEST_CASE("a tilted heap shows its slope, its sign and its height") {
    for (const double slope : {-31.0, -5.0, 0.0, 7.5, 24.0}) {
        const observe::Surface surface =
            observe::free_surface(heap([&](double z) { return 0.05 + tangent(slope) * z; }));
        CHECK(observe::surface_slope(surface) == about(slope, 1e-9));
        CHECK(observe::surface_slope_left(surface) == about(slope, 1e-9));
        CHECK(observe::surface_slope_right(surface) == about(slope, 1e-9));
        // The middle column is the median one; its top stands a radius above its centre. A strip shows its highest
        // point, up to half a strip (5 mm) off its middle.
        const double middle = 0.055 - surface.lowest;
        CHECK(std::abs(observe::bulk_height(surface) - middle) <= 1e-9 + 0.005 * std::abs(tangent(slope)));
    }
}

TEST_CASE("a roof of two slopes shows one of each sign in its halves and none as a whole") {
    const observe::Surface surface = observe::free_surface(heap([](double z) { return -tangent(20) * std::abs(z); }));
    CHECK(observe::surface_slope_left(surface) == about(20, 1e-9));
    CHECK(observe::surface_slope_right(surface) == about(-20, 1e-9));
    CHECK(std::abs(observe::surface_slope(surface)) < 2.0);
}

TEST_CASE("a few bodies in flight above the heap do not tilt its surface") {
    observe::Frame frame = heap([](double z) { return tangent(12) * z; });
    for (const double z : {-0.17, -0.12, 0.04})
        add_body(frame, {0, 0.6, z});
    CHECK(observe::surface_slope(observe::free_surface(frame)) == about(12, 0.02));
}

TEST_CASE("tops of a turned body's spheres count, not its centre") {
    observe::FrameShape rod = ball(0.005, 1e-3);
    rod.centres = {Vector3d(-0.1, 0, 0), Vector3d(0.1, 0, 0)};
    rod.radii = {0.005, 0.005};
    observe::Frame frame;
    frame.layout = open_layout(rod);
    add_body(frame, {0, 0, 0});
    frame.orientation[0] = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ()); // stands upright
    const observe::Surface surface = observe::free_surface(frame);
    REQUIRE(surface.points.size() == 1);
    CHECK(surface.points[0].y() == about(0.105));
    CHECK(surface.lowest == about(-0.105));
}

TEST_CASE("a robust line ignores up to a quarter of wild points and needs three") {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 40; ++i)
        points.emplace_back(i, i % 4 == 3 ? 1e3 : 2.0 - 0.5 * i);
    const auto line = observe::robust_line(points);
    REQUIRE(line);
    CHECK(line->slope == about(-0.5, 0.05));
    CHECK_FALSE(observe::robust_line({{0, 0}, {1, 1}}));
    CHECK_FALSE(observe::robust_line({{1, 0}, {1, 1}, {1, 2}}));
}

TEST_CASE("no bodies, a periodic z or a lost body give no surface, not a wrong one") {
    observe::Frame empty;
    empty.layout = open_layout(ball(0.005, 1e-3));
    CHECK(std::isnan(observe::surface_slope(observe::free_surface(empty))));
    CHECK(std::isnan(observe::bulk_height(observe::free_surface(empty))));
    observe::Frame lost = heap([](double) { return 0.0; });
    add_body(lost, {0, 0, 1e30});
    CHECK(observe::free_surface(lost).points.empty());
    auto periodic = open_layout(ball(0.005, 1e-3));
    periodic->periodic[2] = true;
    observe::Frame wrapped = heap([](double) { return 0.0; });
    wrapped.layout = periodic;
    CHECK(observe::free_surface(wrapped).points.empty());
}

} // namespace test_surface
