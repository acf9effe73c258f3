#include "about.h"
#include "base/rng.h"
#include "fit/report.h"
#include "fit/spheres.h"
#include "scene/read_clump.h"

#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <numbers>
#include <string>

namespace test_fit {

using namespace tumble;
using namespace tumble::fit;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

/// A box from the origin, sides a, b, c; corners of a face in the order that points outwards.
std::vector<Triangle> box(double a, double b, double c) {
    const auto at = [&](int i) { return Vector3d(i & 1 ? a : 0, i & 2 ? b : 0, i & 4 ? c : 0); };
    std::vector<Triangle> faces;
    for (const auto& [p, q, r, s] : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                     std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
        faces.push_back({at(p), at(q), at(r)});
        faces.push_back({at(p), at(r), at(s)});
    }
    return faces;
}

} // namespace

TEST_CASE("a box has the volume, centre and second moments of a box, whichever way it is turned") {
    std::vector<Triangle> faces = box(0.01, 0.02, 0.03);
    for (int turn = 0; turn < 2; ++turn) {
        const Solid solid = solid_of(faces).value();
        CHECK(solid.volume == about(6e-6));
        CHECK(solid.area == about(2 * (2 + 3 + 6) * 1e-4));
        CHECK((solid.centre - Vector3d(0.005, 0.01, 0.015)).norm() < 1e-15);
        CHECK(solid.second(0, 0) == about(6e-6 * 1e-4 / 12));
        CHECK(solid.second(2, 2) == about(6e-6 * 9e-4 / 12));
        CHECK(std::abs(solid.second(0, 1)) < 1e-20);
        for (auto& face : faces)
            std::swap(face[0], face[1]);
    }
}

TEST_CASE("a cone has the volume and centre of a cone") {
    const Solid solid = solid_of(Cone{0.010, 0.012});
    CHECK(solid.volume == about(pi * 0.005 * 0.005 * 0.012 / 3, 2e-5));
    CHECK(solid.centre.y() == about(0.003));
    // Of the round cone: m (3/20 r^2 + 3/80 h^2) across, 3/10 m r^2 along its axis.
    CHECK(solid.second(0, 0) + solid.second(2, 2) == about(0.3 * 25e-6 * solid.volume, 1e-4));
    CHECK(solid.second(1, 1) == about(3.0 / 80 * 144e-6 * solid.volume));
}

TEST_CASE("the bowl's cone of 36 spheres is what its command makes") {
    // tumble fit --cone 10,12 --spheres 36 --smallest 0.775 --volume 294.609
    const auto kept = scene::read_clump(TUMBLE_ROOT "/scenes/clumps/cone-36.csv").value();
    auto made = spheres_in(Cone{0.010, 0.012}, {36, 0.775e-3}).value();
    scale_to_volume(made, 294.609e-9);
    REQUIRE(made.size() == kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        CHECK((made[i].centre - kept[i].centre).norm() < 1e-12);
        CHECK(made[i].radius == about(kept[i].radius, 1e-9));
    }
}

TEST_CASE("depth is the distance to the nearest face, negative outside") {
    const Solid solid = solid_of(box(1, 2, 3)).value();
    CHECK(depth_in(solid, {0.5, 1, 1.5}) == about(0.5));
    CHECK(depth_in(solid, {0.9, 1, 1.5}) == about(0.1));
    CHECK(depth_in(solid, {-3, 1, 7}) == about(-5));
}

TEST_CASE("points of the surface lie on it, as many a face as its area") {
    const Solid solid = solid_of(box(1, 2, 3)).value();
    const auto points = surface_points(solid, 11000);
    REQUIRE(points.size() == 11000);
    int below = 0;
    for (const Vector3d& point : points) {
        CHECK(std::abs(depth_in(solid, point)) < 1e-12);
        below += point.z() < 1e-12 ? 1 : 0;
    }
    CHECK(below == about(1000, 0.01)); // 2 of 22
}

TEST_CASE("an open mesh and one whose triangles are turned against each other are refused, with how many edges") {
    std::vector<Triangle> open = box(1, 1, 1);
    open.pop_back();
    const auto refused = solid_of(open);
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].what.find("3 of its 18 edges") != std::string::npos);
    std::vector<Triangle> turned = box(1, 1, 1);
    std::swap(turned[0][1], turned[0][2]);
    CHECK(!solid_of(turned).ok());
}

TEST_CASE("the spheres of a cone are as many as asked for, touch it from inside and are the same each time") {
    const Cone cone{0.010, 0.012};
    const Solid solid = solid_of(cone);
    for (const int n : {8, 20, 36, 65}) {
        CAPTURE(n);
        const auto spheres = spheres_in(cone, {n, 0.0006}).value();
        CHECK(spheres.size() == static_cast<std::size_t>(n));
        for (const scene::Sphere& sphere : spheres) {
            CHECK(sphere.radius > 0.0006 * (1 - 1e-12));
            CHECK(depth_in(solid, sphere.centre) == about(sphere.radius, 2e-4));
        }
        const auto again = spheres_in(cone, {n, 0.0006}).value();
        for (std::size_t i = 0; i < spheres.size(); ++i)
            CHECK(again[i].centre == spheres[i].centre);
        const Report report = compare(solid, spheres);
        CHECK(report.stands_out < 1e-7);
        CHECK(report.union_volume < solid.volume);
        CHECK(std::abs(report.union_centre.x()) < 0.01 * cone.diameter); // rings of an odd number lean a little
    }
    const auto large = spheres_in(cone, {36, 0.004}); // the inscribed sphere has 3.33 mm
    REQUIRE(!large.ok());
    CHECK(large.problems()[0].fix.starts_with("give --smallest below that and above 0; a quarter of it, 0.8"));
    CHECK(!spheres_in(cone, {7, 0.0006}).ok());
}

TEST_CASE("more spheres fill a cone better") {
    const Cone cone{0.010, 0.012};
    double before = 0;
    for (const int n : {10, 20, 36, 65, 130}) {
        const double volume = compare(solid_of(cone), spheres_in(cone, {n, 0.0003}).value()).union_volume;
        CHECK(volume > before);
        before = volume;
    }
    CHECK(before > 0.88 * solid_of(cone).volume); // the sharp rim stays empty
}

TEST_CASE("the report of one sphere in a cube: pi / 6 of the volume, off by nothing at faces and by a corner's rest") {
    const Solid cube = solid_of(box(2, 2, 2)).value();
    const Report report = compare(cube, {{Vector3d(1, 1, 1), 1}});
    CHECK(report.union_volume / report.solid_volume == about(pi / 6));
    CHECK(report.gap_max == about(std::sqrt(3.0) - 1, 0.02));
    // The cube has 8 m3; to it belongs the factor (6 / pi)^(1/3) = 1.2407.
    REQUIRE(!advice(report).empty());
    CHECK(advice(report)[0].starts_with("--volume 8e+09 gives the body"));
    CHECK(advice(report)[0].ends_with("all lengths times 1.2407"));
    CHECK(report.gap_mean > 0.2);
    CHECK(report.stands_out == 0);
    CHECK(compare(cube, {{Vector3d(1, 1, 1), 1.25}}).stands_out == about(0.25));
    CHECK(report.union_inertia[0] == about(0.4 * report.union_volume));
    CHECK(report.solid_inertia[0] == about(8 * 4.0 / 6));
}

TEST_CASE("spheres in a closed mesh stay inside it and fill it; a long box gets a row of its thickness") {
    const Solid bar = solid_of(box(0.04, 0.01, 0.01)).value();
    const auto few = spheres_in(bar, {4, 0.001}).value();
    const auto many = spheres_in(bar, {60, 0.0005}).value();
    for (const scene::Sphere& sphere : many)
        CHECK(depth_in(bar, sphere.centre) == about(sphere.radius));
    for (const scene::Sphere& sphere : few)
        CHECK(sphere.radius > 0.0044); // points of the grid, 1 mm apart, lie 0.5 mm off the axis
    CHECK(compare(bar, many).union_volume > compare(bar, few).union_volume);
    CHECK(compare(bar, many).union_volume > 0.7 * bar.volume);
    const auto refused = spheres_in(bar, {4, 0.006});
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].fix == "let them be smaller (--smallest), or look at the unit of the mesh (--scale)");
    CHECK(!spheres_in(bar, {100000, 0.004}).ok());
}

TEST_CASE("asked for many points, depths are those of each by itself, bit for bit, and so are spheres on two threads") {
    Rng rng(5);
    for (const Solid& solid : {solid_of(box(0.04, 0.01, 0.02)).value(), solid_of(Cone{0.02, 0.024})}) {
        const Depths depths(solid);
        int inside = 0;
        for (int k = 0; k < 1500; ++k) {
            const Vector3d point(rng.uniform(-0.03, 0.05), rng.uniform(-0.01, 0.03), rng.uniform(-0.03, 0.03));
            const double depth = depth_in(solid, point);
            CHECK(depths.at(point) == depth);
            CHECK(depths.distance2(point, 1.01 * depth * depth) == depths.distance2(point));
            inside += depth > 0 ? 1 : 0;
        }
        CHECK(inside > 10);
        const auto one = spheres_in(solid, {40, 0.0008}).value(), two = spheres_in(solid, {40, 0.0008}, 2).value();
        REQUIRE(one.size() == two.size());
        for (std::size_t k = 0; k < one.size(); ++k) {
            CHECK(one[k].centre == two[k].centre);
            CHECK(one[k].radius == two[k].radius);
            CHECK(one[k].radius == depth_in(solid, one[k].centre)); // signs of the grid's points come from few of them
        }
    }
}

TEST_CASE("a fit counts for whoever listens: each count rises to its end, of a cone's tries and of a mesh's spheres") {
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> heard; // the last of each
    const Tally tally = [&](std::string_view what, std::int64_t done, std::int64_t all) {
        auto& [before, of] = heard[std::string(what)];
        CHECK(done > before);
        CHECK(done <= all);
        before = done;
        of = all;
    };
    const Solid bar = solid_of(box(0.04, 0.01, 0.01)).value();
    const auto told = spheres_in(bar, {12, 0.001}, 2, nullptr, tally).value();
    CHECK(told.front().centre == spheres_in(bar, {12, 0.001}).value().front().centre);
    CHECK(spheres_in(Cone{0.010, 0.012}, {8, 0.0006}, tally).ok());
    CHECK(heard["spheres chosen"] == std::pair<std::int64_t, std::int64_t>{12, 12});
    CHECK(heard["layers of the grid measured"].second == 10); // of 40 along the bar's longest side
    // One ring takes at least 3 of the 8 and leaves 2 to 5 for the axis, two rings at least 6 and leave it 2.
    CHECK(heard["arrangements tried"] == std::pair<std::int64_t, std::int64_t>{5, 5});
    for (const auto& [what, counted] : heard)
        CHECK_MESSAGE(counted.first == counted.second, what);
}

TEST_CASE("a fit that is told to stop does") {
    const std::atomic<bool> stop{true};
    const auto spheres = spheres_in(solid_of(box(0.04, 0.01, 0.01)).value(), {4, 0.001}, 1, &stop);
    REQUIRE(!spheres.ok());
    CHECK(spheres.problems()[0].what == "stopped before the spheres were found");
}

TEST_CASE("scaled to a volume, the union has it, and the clump file reads back to the same spheres") {
    auto spheres = spheres_in(Cone{0.010, 0.012}, {36, 0.000775}).value();
    const double factor = scale_to_volume(spheres, 3e-7);
    CHECK(factor > 1);
    const Report report = compare(solid_of(Cone{0.010, 0.012}), spheres);
    CHECK(report.union_volume == about(3e-7, 1e-7));
    Report near = report;
    near.union_volume = 0.995 * near.solid_volume;
    CHECK(advice(near).empty());
    CHECK(report.stands_out > 0);
    CHECK(equivalent_radius(report.union_volume) == about(std::cbrt(3 * 3e-7 / (4 * pi))));
    const std::string text = clump_file(spheres, report, {"a line"});
    CHECK(text.starts_with("# a line\n# 36 spheres, "));
    const auto read = scene::parse_clump(text, "cone.csv").value();
    REQUIRE(read.size() == spheres.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        CHECK(read[i].centre == spheres[i].centre);
        CHECK(read[i].radius == spheres[i].radius);
    }
}

TEST_CASE("the thesis' cone of 65 spheres is short of its own cone of 20 by 24 mm") {
    const auto spheres = scene::read_clump(TUMBLE_ROOT "/scenes/clumps/cone-65.csv").value();
    const Report report = compare(solid_of(Cone{0.020, 0.024}), spheres);
    CHECK(report.solid_volume == about(pi * 1e-4 * 0.024 / 3, 1e-4));
    CHECK(report.union_volume == about(2.80571e-6, 1e-5)); // fuller than the ideal cone
}

} // namespace test_fit
