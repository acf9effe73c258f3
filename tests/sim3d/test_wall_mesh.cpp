#include "about.h"
#include "sim3d/meshes.h"

#include <doctest/doctest.h>

namespace test_wall_mesh {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

TEST_CASE("rolling over flat triangles is rolling over a plane: one touch, one feature, no jump, on either side") {
    Rng rng(1);
    const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const Vector3d shift(0.1, -0.2, 0.05), u = turn.col(0), v = turn.col(2), normal = turn.col(1);
    Triangles triangles;
    add_sheet(triangles, shift, 0.5 * u, 0.5 * v, 10, 10, rng);
    const WallSurface sheet = surface_of(triangles);
    const double radius = 0.02;
    int feature = -1;
    for (int i = 0; i < 3000; ++i) {
        // A third at corners, a third on edges and diagonals, a third anywhere; some a hair beside.
        double s = rng.uniform(0.05, 0.45), t = rng.uniform(0.05, 0.45);
        if (i % 3 == 0)
            s = 0.05 * std::round(s / 0.05), t = 0.05 * std::round(t / 0.05);
        else if (i % 3 == 1)
            s = (i % 2 ? 0.05 * std::round(s / 0.05) : t);
        if (i % 7 == 0)
            s += rng.uniform(-1, 1) * std::pow(10, rng.uniform(-17, -6));
        const double height = (i % 5 == 0 ? -1 : 1) * radius * rng.uniform(0.6, 0.99999);
        const auto found = touches(sheet, shift + s * u + t * v + height * normal, radius);
        REQUIRE(found.size() == 1);
        CHECK((found[0].normal - (height < 0 ? -1 : 1) * normal).norm() < 1e-12);
        CHECK(std::abs(found[0].gap - (std::abs(height) - radius)) < 1e-15 + 1e-13 * radius);
        if (feature < 0)
            feature = found[0].feature;
        CHECK(found[0].feature == feature);
    }
}

TEST_CASE("a sphere far larger than the triangles still touches their plane once") {
    Rng rng(8);
    Triangles triangles;
    add_sheet(triangles, Vector3d(-0.5, 0, -0.5), Vector3d(1, 0, 0), Vector3d(0, 0, 1), 60, 60, rng);
    const WallSurface sheet = surface_of(triangles);
    for (int i = 0; i < 50; ++i) {
        const auto found = touches(sheet, Vector3d(rng.uniform(-0.1, 0.1), 0.2, rng.uniform(-0.1, 0.1)), 0.3);
        REQUIRE(found.size() == 1);
        CHECK((found[0].normal - Vector3d::UnitY()).norm() < 1e-12);
        CHECK(std::abs(found[0].gap + 0.1) < 1e-13);
    }
}

TEST_CASE("inside, a mesh box equals the analytic box at thousands of places") {
    Rng rng(4);
    const Vector3d lo(-0.3, -0.2, -0.25), hi(0.3, 0.35, 0.2);
    const WallSurface mesh = surface_of(box_mesh(lo, hi, 3, rng));
    const WallSurface box = WallSurface::make(scene::BoxShape{{lo, hi}, {}}, domain_of()).value();
    const double radius = 0.05;
    std::array<int, 4> met{};
    for (int i = 0; i < 20000; ++i) {
        Vector3d centre;
        for (int axis = 0; axis < 3; ++axis) {
            centre[axis] = rng.uniform(lo[axis] + 0.5 * radius, hi[axis] - 0.5 * radius);
            if (rng.uniform() < 0.5) // near a face, so that edges and corners are met often
                centre[axis] = rng.uniform() < 0.5 ? lo[axis] + radius * rng.uniform(0.5, 1.1)
                                                   : hi[axis] - radius * rng.uniform(0.5, 1.1);
        }
        const auto by_mesh = touches(mesh, centre, radius), by_box = touches(box, centre, radius);
        REQUIRE(by_mesh.size() == by_box.size());
        ++met[by_box.size()];
        for (const WallTouch& expected : by_box) {
            double best = 1;
            for (const WallTouch& touch : by_mesh)
                best = std::min(best, (touch.normal - expected.normal).norm() + std::abs(touch.gap - expected.gap));
            CHECK(best < 1e-12);
        }
    }
    CHECK(*std::min_element(met.begin(), met.end()) > 100);
}

TEST_CASE("outside, a mesh box is touched on faces, edges and corners at the distances of theory, always once") {
    Rng rng(6);
    const Vector3d lo(-0.1, -0.2, -0.15), hi(0.1, 0.1, 0.2);
    const WallSurface mesh = surface_of(box_mesh(lo, hi, 2, rng));
    const double radius = 0.07;
    std::array<int, 3> met{};
    for (int i = 0; i < 20000; ++i) {
        Vector3d centre;
        for (int axis = 0; axis < 3; ++axis)
            centre[axis] = rng.uniform(lo[axis] - radius, hi[axis] + radius);
        const Vector3d away = centre - centre.cwiseMax(lo).cwiseMin(hi);
        const double far = away.norm();
        if (far == 0)
            continue;
        const auto found = touches(mesh, centre, radius);
        REQUIRE(found.size() == (far < radius ? 1 : 0));
        if (found.empty())
            continue;
        CHECK((found[0].normal - away / far).norm() < 1e-12);
        CHECK(std::abs(found[0].gap - (far - radius)) < 1e-14);
        ++met[static_cast<std::size_t>((away.array() != 0).count() - 1)];
    }
    CHECK(*std::min_element(met.begin(), met.end()) > 300);
}

TEST_CASE("a straight edge cut into pieces is one feature, a corner another") {
    Rng rng(6);
    const WallSurface mesh = surface_of(box_mesh(Vector3d(-0.2, -0.2, -0.2), Vector3d(0.2, 0.2, 0.2), 4, rng));
    std::map<int, int> edge, corner;
    for (double x = -0.199; x < 0.2; x += 0.001)
        ++edge[touches(mesh, Vector3d(x, 0.203, 0.204), 0.01).at(0).feature];
    for (double x = 0.201; x < 0.205; x += 0.001)
        ++corner[touches(mesh, Vector3d(x, 0.203, 0.204), 0.01).at(0).feature];
    CHECK(edge.size() == 1);
    CHECK(corner.size() == 1);
    CHECK(edge.begin()->first != corner.begin()->first);
    CHECK(touches(mesh, Vector3d(0.1, 0.203, 0.204), 0.01)[0].feature == edge.begin()->first); // on a cut
}

TEST_CASE("rolling over a sharp edge turns the normal smoothly") {
    // A roof of two sheets at a right angle, ridge along z at the origin; the sphere's centre keeps 0.9 r from it.
    Rng rng(2);
    Triangles triangles;
    const double slope = std::sqrt(0.5), radius = 0.02;
    add_sheet(triangles, Vector3d(0, 0, -0.2), Vector3d(0, 0, 0.4), 0.3 * Vector3d(slope, -slope, 0), 5, 3, rng);
    add_sheet(triangles, Vector3d(0, 0, -0.2), Vector3d(0, 0, 0.4), 0.3 * Vector3d(-slope, -slope, 0), 5, 3, rng);
    const WallSurface roof = surface_of(triangles);
    Vector3d last(slope, slope, 0);
    for (double run = -0.03; run < 0.06; run += 1e-4) {
        const double angle = pi / 4 + std::clamp(run / (0.9 * radius), 0.0, pi / 2);
        const Vector3d normal(std::cos(angle), std::sin(angle), 0);
        const double before = std::max(0.0, -run), after = std::max(0.0, run - 0.9 * radius * pi / 2);
        const Vector3d centre =
            0.9 * radius * normal + before * Vector3d(slope, -slope, 0) + after * Vector3d(-slope, -slope, 0);
        const auto found = touches(roof, centre, radius);
        REQUIRE(found.size() == 1);
        CHECK((found[0].normal - normal).norm() < 1e-9);
        CHECK(std::abs(found[0].gap + 0.1 * radius) < 1e-12);
        CHECK((found[0].normal - last).norm() < 0.01);
        last = found[0].normal;
    }
}

TEST_CASE("in a groove both sides push, also where they meet in a vertex of the mesh") {
    Rng rng(2);
    Triangles triangles;
    const double slope = std::sqrt(0.5), radius = 0.02;
    add_sheet(triangles, Vector3d(0, 0, -0.2), Vector3d(0, 0, 0.4), 0.3 * Vector3d(slope, slope, 0), 5, 3, rng);
    add_sheet(triangles, Vector3d(0, 0, -0.2), Vector3d(0, 0, 0.4), 0.3 * Vector3d(-slope, slope, 0), 5, 3, rng);
    const WallSurface groove = surface_of(triangles);
    for (double z : {0.0, -0.04, 0.04, 0.12, 0.0301}) {
        const auto found = touches(groove, Vector3d(0, 0.9 * radius / slope, z), radius);
        REQUIRE(found.size() == 2);
        CHECK(std::abs(found[0].gap + 0.1 * radius) < 1e-14);
        CHECK(std::abs(found[1].gap + 0.1 * radius) < 1e-14);
        CHECK((found[0].normal + found[1].normal - Vector3d(0, 2 * slope, 0)).norm() < 1e-12);
    }
}

TEST_CASE("a rib that stands on a floor does not cut the floor") {
    Rng rng(3);
    Triangles triangles;
    add_sheet(triangles, Vector3d(-0.2, 0, -0.2), Vector3d(0.4, 0, 0), Vector3d(0, 0, 0.4), 4, 4, rng);
    add_sheet(triangles, Vector3d(0, 0, -0.2), Vector3d(0, 0.1, 0), Vector3d(0, 0, 0.4), 1, 4, rng);
    const WallSurface wall = surface_of(triangles);
    const double radius = 0.02;
    // From below the rib is not there, from above the sphere stands between both.
    for (double x = -0.03; x <= 0.03; x += 0.001) {
        const auto below = touches(wall, Vector3d(x, -0.015, 0.01), radius);
        REQUIRE(below.size() == 1);
        CHECK((below[0].normal + Vector3d::UnitY()).norm() < 1e-12);
    }
    CHECK(touches(wall, Vector3d(0, -0.015, 0.1), radius).size() == 1); // under a corner of the rib
    const auto corner = touches(wall, Vector3d(0.018, 0.019, 0.05), radius);
    REQUIRE(corner.size() == 2);
    CHECK((corner[0].normal + corner[1].normal - Vector3d(1, 1, 0)).norm() < 1e-12);
}

TEST_CASE("a sphere in a square hole touches its four edges") {
    Rng rng(3);
    Triangles triangles;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != 1 || j != 1)
                add_sheet(triangles, Vector3d(0.1 * i - 0.15, 0, 0.1 * j - 0.15), Vector3d(0.1, 0, 0),
                          Vector3d(0, 0, 0.1), 1, 1, rng);
    const WallSurface plate = surface_of(triangles);
    // Centre 0.03 above the hole's middle: sqrt(0.03^2 + 0.05^2) = 0.0583 from each edge.
    const auto found = touches(plate, Vector3d(0, 0.03, 0), 0.06);
    REQUIRE(found.size() == 4);
    for (const WallTouch& touch : found) {
        CHECK(touch.gap == about(std::hypot(0.03, 0.05) - 0.06));
        CHECK(touch.normal.y() == about(0.03 / std::hypot(0.03, 0.05)));
    }
}

TEST_CASE("on a curved mesh some touch is there whenever something is in reach, and from outside exactly one") {
    Rng rng(9);
    for (int rounds : {0, 1, 3}) {
        const WallSurface ball = surface_of(icosphere(0.5, rounds));
        for (int i = 0; i < 3000; ++i) {
            const Vector3d direction = random_direction(rng);
            const double radius = rng.uniform(0.02, 0.15);
            const Vector3d outside = direction * (0.5 + radius * rng.uniform(0.3, 1.2)),
                           inside = direction * (0.5 - radius * rng.uniform(0.3, 1.2));
            const double far = nearest_of(ball, outside);
            const auto found = touches(ball, outside, radius);
            REQUIRE(found.size() == (far < radius ? 1 : 0));
            if (!found.empty())
                CHECK(std::abs(found[0].gap - (far - radius)) < 1e-13);

            const double near = nearest_of(ball, inside);
            const auto held = touches(ball, inside, radius);
            REQUIRE(held.empty() == (near >= radius));
            double deepest = 0;
            for (const WallTouch& touch : held) {
                deepest = std::min(deepest, touch.gap);
                CHECK(std::abs(touch.normal.norm() - 1) < 1e-12);
            }
            if (!held.empty())
                CHECK(std::abs(deepest - (near - radius)) < 1e-13);
        }
        // Straight over corners and edge middles, where regions tie.
        for (const auto& triangle : icosphere(0.5, rounds))
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(touches(ball, triangle[k] * 1.08, 0.05).size() == 1);
                const Vector3d middle = (triangle[k] + triangle[(k + 1) % 3]) / 2;
                CHECK(touches(ball, middle + 0.04 * middle.normalized(), 0.05).size() == 1);
            }
    }
}

TEST_CASE("the tree finds exactly the triangles that looking at every one finds, in order") {
    Rng rng(10);
    const WallSurface ball = surface_of(icosphere(0.5, 3));
    std::vector<int> found;
    for (int i = 0; i < 2000; ++i) {
        const Vector3d centre = random_direction(rng) * rng.uniform(0, 0.8);
        const double reach = rng.uniform(0.001, 0.3);
        std::vector<int> expected;
        for (int primitive = 0; primitive < ball.primitives(); ++primitive)
            if (ball.distance(primitive, centre) < reach)
                expected.push_back(primitive);
        ball.primitives_near(centre, reach, found);
        REQUIRE(found == expected);
    }
}

TEST_CASE("primitives that are listed although out of reach change nothing") {
    Rng rng(12);
    const WallSurface mesh = surface_of(box_mesh(Vector3d(-0.2, -0.2, -0.2), Vector3d(0.2, 0.2, 0.2), 3, rng));
    std::vector<int> wide;
    for (int i = 0; i < 2000; ++i) {
        const Vector3d centre(rng.uniform(-0.25, 0.25), rng.uniform(-0.25, 0.25), rng.uniform(-0.25, 0.25));
        const auto exact = touches(mesh, centre, 0.03);
        mesh.primitives_near(centre, 0.1, wide);
        std::array<WallTouch, 16> out;
        REQUIRE(mesh.touches(centre, 0.03, wide, out) == static_cast<int>(exact.size()));
        for (std::size_t k = 0; k < exact.size(); ++k) {
            CHECK(out[k].feature == exact[k].feature);
            CHECK(out[k].gap == exact[k].gap);
        }
    }
}

TEST_CASE("a mesh that ends at a periodic side goes on there as if it were longer") {
    Rng rng(13);
    const WallSurface periodic = surface_of(trough_strip(-1, 1, 4, rng), {true, false, false});
    const WallSurface longer = surface_of(trough_strip(-3, 3, 12, rng));
    const double radius = 0.03;
    for (int i = 0; i < 3000; ++i) {
        const double x = i % 3 == 0 ? 1.0 : i % 3 == 1 ? rng.uniform(0.98, 1.02) : -rng.uniform(0.98, 1.02);
        const double angle = (i % 2 ? pi / 36 * std::round(rng.uniform(2, 34)) : rng.uniform(0.1, pi - 0.1));
        const Vector3d down(0, -std::sin(angle), -std::cos(angle));
        const Vector3d centre = Vector3d(x, 0, 0) + (0.24 - radius * rng.uniform(0.6, 1.01)) * down;
        const auto found = touches(periodic, centre, radius), expected = touches(longer, centre, radius);
        REQUIRE(found.size() == expected.size());
        for (const WallTouch& touch : found) {
            double best = 1;
            for (const WallTouch& other : expected)
                best = std::min(best, (touch.normal - other.normal).norm() + std::abs(touch.gap - other.gap));
            CHECK(best < 1e-12);
        }
        // The same place one period on has the same features.
        const auto wrapped = touches(periodic, centre - Vector3d(x < 0 ? -2 : 2, 0, 0), radius);
        REQUIRE(wrapped.size() == found.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            CHECK(wrapped[k].feature == found[k].feature);
    }
}

TEST_CASE("without a periodic side the end of a sheet is an edge") {
    Rng rng(13);
    Triangles triangles;
    add_sheet(triangles, Vector3d(-1, 0, -1), Vector3d(2, 0, 0), Vector3d(0, 0, 2), 3, 3, rng);
    const Vector3d past_end(1.003, 0.004, 0);
    const auto edge = touches(surface_of(triangles), past_end, 0.01);
    REQUIRE(edge.size() == 1);
    CHECK((edge[0].normal - Vector3d(0.6, 0.8, 0)).norm() < 1e-10);
    for (std::array<bool, 3> periodic : {std::array{true, false, false}, std::array{true, false, true}}) {
        const auto flat = touches(surface_of(triangles, periodic), past_end, 0.01);
        REQUIRE(flat.size() == 1);
        CHECK((flat[0].normal - Vector3d::UnitY()).norm() < 1e-12);
        CHECK(flat[0].feature == touches(surface_of(triangles, periodic), Vector3d(0, 0.004, 0), 0.01)[0].feature);
    }
    CHECK(touches(surface_of(triangles, {true, false, true}), Vector3d(1.003, 0.004, -1.002), 0.01).size() == 1);
}

TEST_CASE("a thing that stands across a periodic side is met on both ends of the domain") {
    Rng rng(14);
    const WallSurface post =
        surface_of(box_mesh(Vector3d(0.9, -0.5, -0.1), Vector3d(1.1, 0.5, 0.1), 2, rng), {true, false, false});
    const auto found = touches(post, Vector3d(-0.895, 0.2, 0), 0.01); // its face at 1.1 stands at -0.9 as well
    REQUIRE(found.size() == 1);
    CHECK((found[0].normal - Vector3d::UnitX()).norm() < 1e-12);
    CHECK(std::abs(found[0].gap + 0.005) < 1e-12);
    CHECK(found[0].feature == touches(post, Vector3d(1.105, 0.2, 0), 0.01).at(0).feature);
}

TEST_CASE("vertices that differ by single precision are one") {
    Rng rng(15);
    Triangles triangles;
    add_sheet(triangles, Vector3d(-0.5, 0.01, -0.5), Vector3d(1, 0, 0), Vector3d(0, 0, 1), 7, 7, rng);
    for (auto& triangle : triangles)
        for (Vector3d& corner : triangle)
            corner = corner.cast<float>().cast<double>() + 1e-8 * random_direction(rng);
    const WallSurface sheet = surface_of(triangles);
    for (int i = 0; i < 500; ++i) {
        const auto found = touches(sheet, Vector3d(rng.uniform(-0.4, 0.4), 0.04, rng.uniform(-0.4, 0.4)), 0.032);
        REQUIRE(found.size() == 1);
        CHECK((found[0].normal - Vector3d::UnitY()).norm() < 1e-6);
    }
}

TEST_CASE("broken triangles are named, all at once, and a flood of them is cut short") {
    Triangles good{{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}};
    Triangles triangles = good;
    triangles.push_back({Vector3d(0, 0, 0), Vector3d(0.5, 0.5, 0), Vector3d(1, 1, 0)});
    triangles.push_back({Vector3d(0, 1, 0), Vector3d(0, 0, 0), Vector3d(1, 0, 0)});
    CHECK(problems_of(triangles) == "wall.stl: triangle 2 has no area\n"
                                    "    export the mesh again without degenerate triangles\n"
                                    "wall.stl: triangle 3 is the same as triangle 1\n"
                                    "    remove one of the two, or export the mesh again without doubled faces\n");
    triangles = good;
    triangles[0][1].y() = std::nan("");
    CHECK(problems_of(triangles).find("triangle 1 has a coordinate that is not a number") != std::string::npos);
    triangles = good;
    for (int i = 0; i < 40; ++i)
        triangles.push_back(good[0]);
    CHECK(problems_of(triangles).find("30 more broken triangles") != std::string::npos);
    CHECK(problems_of({{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()}}).find("triangle 1 has no area") == 10);
    CHECK(problems_of({}).find("no triangles") != std::string::npos);
}

} // namespace test_wall_mesh
