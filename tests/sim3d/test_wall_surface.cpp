#include "about.h"
#include "base/rng.h"
#include "sim3d/wall_surface.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_wall_surface {

using namespace tumble;
using namespace tumble::sim3d;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

scene::Domain domain_of(std::array<bool, 3> periodic = {}) {
    scene::Domain domain;
    domain.box = {Vector3d(-1, -1, -1), Vector3d(1, 1, 1)};
    domain.periodic = periodic;
    return domain;
}

WallSurface surface_of(const scene::WallShape& shape, std::array<bool, 3> periodic = {}) {
    return WallSurface::make(shape, domain_of(periodic)).value();
}

std::vector<WallTouch> touches(const WallSurface& surface, const Vector3d& centre, double radius) {
    std::vector<int> near;
    surface.primitives_near(centre, radius, near);
    std::array<WallTouch, 16> out;
    const int count = surface.touches(centre, radius, near, out);
    return {out.begin(), out.begin() + count};
}

void check_touch(const WallTouch& touch, const Vector3d& normal, double gap) {
    CHECK((touch.normal - normal).norm() < 1e-12);
    CHECK(std::abs(touch.gap - gap) < 1e-12);
}

std::string first_problem(const scene::WallShape& shape) {
    const auto result = WallSurface::make(shape, domain_of());
    return result.ok() ? "" : result.problems().front().what;
}

} // namespace

TEST_CASE("a plane pushes to its inside from any depth") {
    const Vector3d normal = Vector3d(1, 2, 2) / 3;
    const WallSurface plane = surface_of(scene::PlaneShape{Vector3d(0.1, 0, 0), normal});
    CHECK(plane.primitives() == 1);
    for (double height : {0.009, 0.0, -0.01, -0.5}) {
        const auto found = touches(plane, Vector3d(0.1, 0, 0) + height * normal + Vector3d(0, 0.3, -0.3), 0.01);
        REQUIRE(found.size() == 1);
        check_touch(found[0], normal, height - 0.01);
        CHECK(found[0].feature == 0);
    }
    CHECK(touches(plane, Vector3d(0.1, 0, 0) + 0.0101 * normal, 0.01).empty());
    CHECK(plane.distance(0, Vector3d(0.1, 0, 0) - 0.2 * normal) == about(-0.2));
}

TEST_CASE("a sphere in a box corner touches three faces, each by its own feature") {
    const WallSurface box = surface_of(scene::BoxShape{{Vector3d(-0.5, -0.4, -0.3), Vector3d(0.5, 0.4, 0.3)}, {}});
    CHECK(box.primitives() == 6);
    const auto found = touches(box, Vector3d(-0.495, 0.391, -0.292), 0.01);
    REQUIRE(found.size() == 3);
    check_touch(found[0], Vector3d::UnitX(), 0.005 - 0.01);
    check_touch(found[1], -Vector3d::UnitY(), 0.009 - 0.01);
    check_touch(found[2], Vector3d::UnitZ(), 0.008 - 0.01);
    CHECK(found[0].feature == 0);
    CHECK(found[1].feature == 3);
    CHECK(found[2].feature == 4);
    // Pressed through, far: still pushed inwards.
    const auto deep = touches(box, Vector3d(0.7, 0, 0), 0.01);
    REQUIRE(deep.size() == 1);
    check_touch(deep[0], -Vector3d::UnitX(), -0.2 - 0.01);
}

TEST_CASE("an open face is no wall and the faces beside it end in a rim") {
    scene::BoxShape shape{{Vector3d(-0.5, -0.5, -0.5), Vector3d(0.5, 0.5, 0.5)}, {}};
    shape.open[3] = true; // +y
    const WallSurface box = surface_of(shape);
    CHECK(box.primitives() == 5);
    CHECK(touches(box, Vector3d(0, 0.499, 0), 0.01).empty());
    CHECK(touches(box, Vector3d(0.3, 0.7, 0), 0.01).empty());
    // Above the rim of +x: nearest is the rim, straight below and to either side.
    auto found = touches(box, Vector3d(0.503, 0.504, 0), 0.01);
    REQUIRE(found.size() == 1);
    check_touch(found[0], Vector3d(0.6, 0.8, 0), 0.005 - 0.01);
    CHECK(found[0].feature == 1);
    // Passing the rim from inside changes nothing suddenly.
    const auto below = touches(box, Vector3d(0.494, 0.5 - 1e-9, 0), 0.01);
    const auto above = touches(box, Vector3d(0.494, 0.5 + 1e-9, 0), 0.01);
    CHECK((below[0].normal - above[0].normal).norm() < 1e-6);
    CHECK(std::abs(below[0].gap - above[0].gap) < 1e-9);
    // A body that went over the rim is pushed outwards, one that was pressed through by less than half is pushed in.
    found = touches(box, Vector3d(0.508, 0.2, 0), 0.01);
    REQUIRE(found.size() == 1);
    check_touch(found[0], Vector3d::UnitX(), 0.008 - 0.01);
    found = touches(box, Vector3d(0.504, 0.2, 0), 0.01);
    check_touch(found[0], -Vector3d::UnitX(), -0.004 - 0.01);
    CHECK(touches(box, Vector3d(0.52, 0.2, 0), 0.01).empty());
    // So can one get under the floor.
    check_touch(touches(box, Vector3d(0, -0.508, 0), 0.01)[0], -Vector3d::UnitY(), 0.008 - 0.01);
    CHECK(touches(box, Vector3d(0, -0.8, 0), 0.01).empty());
}

TEST_CASE("from outside an open box is five thin plates, met once on every edge and corner") {
    scene::BoxShape shape{{Vector3d(-0.5, -0.5, -0.5), Vector3d(0.5, 0.5, 0.5)}, {}};
    shape.open[3] = true; // +y
    const WallSurface box = surface_of(shape);
    CHECK(touches(box, Vector3d(0.7, 0.2, 0), 0.05).empty());
    CHECK(touches(box, Vector3d(0.7, -0.499, 0), 0.05).empty()); // beside the floor, which ends at 0.5
    const double r = 0.05;
    Rng rng(5);
    int met = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3d centre(rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.4), rng.uniform(-0.6, 0.6));
        const Vector3d away = centre - centre.cwiseMax(shape.box.lo).cwiseMin(shape.box.hi);
        if (away.norm() <= 0.5 * r) // inside, or pressed through
            continue;
        const auto found = touches(box, centre, r);
        REQUIRE(found.size() == (away.norm() < r ? 1 : 0));
        if (found.empty())
            continue;
        ++met;
        check_touch(found[0], away.normalized(), away.norm() - r);
    }
    CHECK(met > 500);
}

TEST_CASE("a box that is open where the domain is periodic goes on there without a rim") {
    scene::BoxShape shape{{Vector3d(-1, -0.5, -0.5), Vector3d(1, 0.5, 0.5)}, {true, true, false, false, false, false}};
    const WallSurface box = surface_of(shape, {true, false, false});
    for (double x : {0.999, 1.0, 1.004, -1.2}) {
        const auto found = touches(box, Vector3d(x, -0.495, 0), 0.01);
        REQUIRE(found.size() == 1);
        check_touch(found[0], Vector3d::UnitY(), -0.005);
    }
}

TEST_CASE("a cylinder is touched from inside, from outside and on its ends") {
    const Vector3d axis = Vector3d(0, 3, 4) / 5, side = Vector3d(1, 0, 0), other = axis.cross(side);
    const WallSurface tube = surface_of(scene::CylinderShape{Vector3d(0.1, 0, 0), axis, 0.2, 0.05});
    const Vector3d middle = Vector3d(0.1, 0, 0) + 0.1 * axis, radial = 0.6 * side + 0.8 * other;
    auto found = touches(tube, middle + 0.045 * radial, 0.01);
    REQUIRE(found.size() == 1);
    check_touch(found[0], -radial, 0.005 - 0.01);
    found = touches(tube, middle + 0.057 * radial, 0.01);
    REQUIRE(found.size() == 1);
    check_touch(found[0], radial, 0.007 - 0.01);
    CHECK(touches(tube, middle, 0.01).empty());
    // 3 mm past the end and 4 mm out: 5 mm from the end's circle. There are no lids.
    found = touches(tube, Vector3d(0.1, 0, 0) - 0.003 * axis + 0.054 * radial, 0.01);
    REQUIRE(found.size() == 1);
    check_touch(found[0], -0.6 * axis + 0.8 * radial, 0.005 - 0.01);
    CHECK(touches(tube, Vector3d(0.1, 0, 0), 0.01).empty());
    // On the axis a sphere larger than the tube is held from two opposite sides.
    found = touches(tube, middle, 0.06);
    REQUIRE(found.size() == 2);
    check_touch(found[0], -found[1].normal, -0.01);
    check_touch(found[1], -found[0].normal, -0.01);
    CHECK(std::abs(found[0].normal.dot(axis)) < 1e-12);
}

TEST_CASE("a sphere wider than a hole is held by the rim's nearest point and by the one across, each its own feature") {
    // Rim of 30 mm, sphere of 50 mm, its centre 42 mm up and 3 mm aside: the two stand 27 and 33 mm to the sides.
    const Vector3d aside = Vector3d(0.6, 0, 0.8);
    const WallSurface disc = surface_of(scene::DiscShape{Vector3d::Zero(), Vector3d::UnitY(), 0.2, 0.03});
    const WallSurface tube = surface_of(scene::CylinderShape{Vector3d(0, -0.2, 0), Vector3d::UnitY(), 0.2, 0.03});
    const auto by_depth = [](std::vector<WallTouch> found) {
        REQUIRE(found.size() == 2);
        if (found[0].gap > found[1].gap)
            std::swap(found[0], found[1]);
        return found;
    };
    for (const WallSurface& wall : {disc, tube}) {
        const auto here = by_depth(touches(wall, Vector3d(0, 0.032, 0) + 0.003 * aside, 0.05));
        const Vector3d near = Vector3d(0, 0.032, 0) - 0.027 * aside, far = Vector3d(0, 0.032, 0) + 0.033 * aside;
        check_touch(here[0], near.normalized(), near.norm() - 0.05);
        check_touch(here[1], far.normalized(), far.norm() - 0.05);
        // On the other side of the axis the same two places have changed roles, not features.
        const auto there = by_depth(touches(wall, Vector3d(0, 0.032, 0) - 0.003 * aside, 0.05));
        CHECK(there[0].feature == here[1].feature);
        CHECK(there[1].feature == here[0].feature);
        CHECK(here[0].feature != here[1].feature);
    }
    CHECK(touches(disc, Vector3d(0, 0.002, 0.005), 0.029).size() == 1); // one that fits through
}

TEST_CASE("a cylinder along a periodic axis has no ends") {
    const WallSurface tube =
        surface_of(scene::CylinderShape{Vector3d(-1, 0, 0), Vector3d::UnitX(), 2, 0.3}, {true, false, false});
    CHECK(tube.primitives() == 1);
    for (double x : {-1.02, -1.0, 0.3, 1.0, 1.015}) {
        const auto found = touches(tube, Vector3d(x, -0.295, 0), 0.01);
        REQUIRE(found.size() == 1);
        check_touch(found[0], Vector3d::UnitY(), -0.005);
    }
}

TEST_CASE("a disc is touched on both sides, on its rim and on the rim of its hole") {
    const WallSurface disc = surface_of(scene::DiscShape{Vector3d(0, 0.1, 0), Vector3d::UnitY(), 0.2, 0.05});
    auto found = touches(disc, Vector3d(0.1, 0.108, 0), 0.01);
    REQUIRE(found.size() == 1);
    check_touch(found[0], Vector3d::UnitY(), -0.002);
    found = touches(disc, Vector3d(0.1, 0.093, 0), 0.01);
    check_touch(found[0], -Vector3d::UnitY(), -0.003);
    found = touches(disc, Vector3d(0.203, 0.104, 0), 0.01);
    check_touch(found[0], Vector3d(0.6, 0.8, 0), -0.005);
    found = touches(disc, Vector3d(0, 0.104, 0.047), 0.01);
    check_touch(found[0], Vector3d(0, 0.8, -0.6), -0.005);
    CHECK(found[0].feature == 0);
    CHECK(touches(disc, Vector3d(0, 0.1, 0), 0.01).empty());
    CHECK(touches(disc, Vector3d(0.1, 0.1, 0), 0.01).size() == 1); // in the plate itself
}

TEST_CASE("a disc near a periodic side is met on the other side too, as the same feature") {
    const WallSurface disc =
        surface_of(scene::DiscShape{Vector3d(0.95, 0, 0), Vector3d::UnitY(), 0.2, 0}, {true, false, false});
    CHECK(disc.primitives() == 3);
    const auto here = touches(disc, Vector3d(0.9, 0.008, 0), 0.01),
               there = touches(disc, Vector3d(-0.9, 0.008, 0), 0.01);
    REQUIRE(here.size() == 1);
    REQUIRE(there.size() == 1);
    check_touch(there[0], Vector3d::UnitY(), -0.002);
    CHECK(here[0].feature == there[0].feature);
}

TEST_CASE("the trough's normals point to the arc's centre below and stand on the leaning sides above") {
    const double R = 0.24, flare = 0.1, r = 0.007;
    const WallSurface trough = surface_of(scene::TroughShape{R, -0.3, 0.5, flare, -0.05, 0.05});
    const Vector3d arc(0, -0.3 + R, 0);
    for (double angle = -1.45; angle <= 1.45; angle += 0.05) {
        const Vector3d down(0, -std::cos(angle), std::sin(angle));
        const auto found = touches(trough, arc + Vector3d(7, 0, 0) + (R - 0.9 * r) * down, r);
        REQUIRE(found.size() == 1);
        check_touch(found[0], -down, -0.1 * r);
        CHECK(found[0].feature == 0);
    }
    for (double side : {-1.0, 1.0})
        for (double up : {0.01, 0.2, 0.4}) {
            const Vector3d tangent(0, std::cos(flare), side * std::sin(flare));
            const Vector3d inward(0, std::sin(flare), -side * std::cos(flare));
            const auto found = touches(trough, arc - R * inward + up * tangent + 0.8 * r * inward, r);
            REQUIRE(found.size() == 1);
            check_touch(found[0], inward, -0.2 * r);
            CHECK(found[0].feature == 0);
        }
}

TEST_CASE("a sphere that slides along the whole trough feels no jump, over the junction and over the rim") {
    const double R = 0.2, flare = 0.2, r = 0.01, rim = 0.4;
    const WallSurface trough = surface_of(scene::TroughShape{R, -0.2, rim, flare, 0, 0});
    const double turn = pi / 2 - flare, length = (rim + R * std::sin(flare)) / std::cos(flare);
    Vector3d last(0, 1, 0);
    for (double run = 0; run < R * turn + length + 0.5 * r; run += 1e-4) {
        const double angle = std::min(run / R, turn), up = std::max(0.0, run - R * turn);
        const Vector3d inward(0, std::cos(angle), -std::sin(angle));
        const Vector3d centre = -(R - 0.9 * r) * inward + up * Vector3d(0, std::sin(angle), std::cos(angle));
        const auto found = touches(trough, centre, r);
        if (found.empty()) {
            CHECK(up > length + 0.4 * r); // sqrt(1 - 0.9^2) = 0.436 radii past the rim it comes free
            break;
        }
        REQUIRE(found.size() == 1);
        CHECK((found[0].normal - last).norm() < 0.02);
        CHECK(found[0].gap <= 1e-15);
        if (up <= length)
            CHECK(std::abs(found[0].gap + 0.1 * r) < 1e-12);
        last = found[0].normal;
    }
    // On top of the rim, and outside.
    const double z_rim = R * std::cos(flare) + length * std::sin(flare);
    check_touch(touches(trough, Vector3d(0, rim + 0.009, z_rim), r)[0], Vector3d::UnitY(), -0.001);
    const Vector3d outward(0, -std::sin(flare), std::cos(flare));
    const Vector3d on_side = -R * -outward + 0.1 * Vector3d(0, std::cos(flare), std::sin(flare));
    check_touch(touches(trough, on_side + 0.008 * outward, r)[0], outward, -0.002);
    check_touch(touches(trough, on_side + 0.002 * outward, r)[0], -outward, -0.012);
}

TEST_CASE("a sphere too large for the trough's bottom lies on both sides") {
    // Sides leaning by 30 degrees meet the arc of 10 mm; a sphere of 20 mm rests where its centre is 20 mm from both.
    const double R = 0.01, r = 0.02, flare = pi / 6;
    const WallSurface trough = surface_of(scene::TroughShape{R, 0, 0.1, flare, 0, 0});
    // Distance from (y, 0) to a side: R + (y - R) sin(flare).
    const double y = R + (0.99 * r - R) / std::sin(flare);
    const auto found = touches(trough, Vector3d(0, y, 0), r);
    REQUIRE(found.size() == 2);
    check_touch(found[0], Vector3d(0, std::sin(flare), std::cos(flare)), -0.01 * r);
    check_touch(found[1], Vector3d(0, std::sin(flare), -std::cos(flare)), -0.01 * r);
    CHECK(found[0].feature != found[1].feature);
    const auto left = touches(trough, Vector3d(0, y + 0.001, -0.005), r);
    REQUIRE(left.size() == 1);
    CHECK(left[0].feature == found[0].feature);
}

TEST_CASE("no analytic wall is missed near it, and distances are what touches say") {
    Rng rng(2);
    scene::BoxShape open_box{{Vector3d(-0.4, -0.4, -0.4), Vector3d(0.4, 0.4, 0.4)}, {}};
    open_box.open[3] = true;
    const std::vector<scene::WallShape> shapes{scene::CylinderShape{Vector3d(0, -0.2, 0), Vector3d::UnitY(), 0.4, 0.3},
                                               scene::DiscShape{Vector3d::Zero(), Vector3d(1, 1, 0), 0.4, 0.1},
                                               open_box, scene::TroughShape{0.3, -0.4, 0.5, 0.1, 0, 0}};
    for (const auto& shape : shapes) {
        const WallSurface surface = surface_of(shape);
        const bool inside_only = std::holds_alternative<scene::BoxShape>(shape); // behind it, it pushes from any depth
        int met = 0;
        for (int i = 0; i < 5000; ++i) {
            const double far = inside_only ? 0.4 : 0.6;
            const Vector3d centre(rng.uniform(-far, far), rng.uniform(-far, 0.6), rng.uniform(-far, far));
            double nearest = 1;
            for (int p = 0; p < surface.primitives(); ++p)
                nearest = std::min(nearest, std::abs(surface.distance(p, centre)));
            const auto found = touches(surface, centre, 0.05);
            REQUIRE(found.empty() == (nearest >= 0.05));
            if (found.empty())
                continue;
            ++met;
            double deepest = 0;
            for (const auto& touch : found)
                deepest = std::min(deepest, touch.gap);
            // Pressed through by less than half: the overlap is the radius and the way through.
            const double expected = deepest < -0.05 ? -deepest - 0.05 : deepest + 0.05;
            CHECK(std::abs(expected - nearest) < 1e-12);
        }
        CHECK(met > 100);
    }
}

TEST_CASE("when more is touched than the caller has room for, the deepest stay, in order of features") {
    const WallSurface box = surface_of(scene::BoxShape{{Vector3d(-0.5, -0.5, -0.5), Vector3d(0.5, 0.5, 0.5)}, {}});
    std::array<WallTouch, 2> out;
    const std::array<int, 6> all{0, 1, 2, 3, 4, 5};
    REQUIRE(box.touches(Vector3d(-0.499, -0.491, -0.495), 0.01, all, out) == 2);
    CHECK(out[0].feature == 0);
    CHECK(out[1].feature == 4);
    REQUIRE(box.touches(Vector3d(-0.491, -0.495, -0.499), 0.01, all, out) == 2);
    CHECK(out[0].feature == 2);
    CHECK(out[1].feature == 4);
}

TEST_CASE("sizes that make no wall are refused") {
    CHECK(first_problem(scene::PlaneShape{Vector3d::Zero(), Vector3d::Zero()}) == "the wall's normal has no direction");
    CHECK(first_problem(scene::DiscShape{Vector3d::Zero(), Vector3d::UnitY(), -0.1, 0}) == "the wall's radius is -0.1");
    CHECK(first_problem(scene::DiscShape{Vector3d::Zero(), Vector3d::UnitY(), 0.1, 0.1}) ==
          "a hole of radius 0.1 m leaves nothing of a disc of 0.1 m");
    CHECK(first_problem(scene::TroughShape{0.2, 0.1, 0.1, 0, 0, 0}) ==
          "the rim at 0.1 m is not above the floor at 0.1 m");
    CHECK(first_problem(scene::BoxShape{{Vector3d::Zero(), Vector3d(1, 0, 1)}, {}}) ==
          "the box from [0, 0, 0] to [1, 0, 1] has no volume");
    CHECK(first_problem(scene::MeshShape{}) == "there are no triangles in the mesh");
    CHECK(WallSurface().primitives() == 0);
}

} // namespace test_wall_surface
