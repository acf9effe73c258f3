#include "about.h"
#include "run/wall_triangles.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <numbers>

namespace test_wall_triangles {

using namespace tumble;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

scene::Domain domain(std::array<bool, 3> periodic = {true, false, false}) {
    return {{Vector3d(-0.05, 0, -0.3), Vector3d(0.05, 0.6, 0.3)}, periodic};
}

observe::FrameWall triangles(scene::WallShape shape, std::array<bool, 3> periodic = {true, false, false}) {
    scene::Wall wall;
    wall.name = "wall";
    wall.shape = std::move(shape);
    return run::wall_triangles(wall, domain(periodic));
}

double area(const observe::FrameWall& wall) {
    double sum = 0;
    for (const auto& t : wall.triangles) {
        const auto at = [&](int k) { return wall.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
        sum += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    return sum;
}

/// Polygons inscribed in a circle of n corners miss this share of its length.
double chord_share(int n) {
    return std::sin(std::numbers::pi / n) / (std::numbers::pi / n);
}

} // namespace

TEST_CASE("a plane is cut to the polygon that lies in the domain") {
    scene::PlaneShape floor;
    floor.point = {7, 0.1, -9};
    CHECK(area(triangles(floor)) == about(0.1 * 0.6));
    floor.point.y() = 0; // on the domain's own face
    CHECK(area(triangles(floor)) == about(0.1 * 0.6));
    floor.point.y() = 2;
    CHECK(triangles(floor).triangles.empty());
    scene::PlaneShape tilted; // 45 degrees about x through the middle: from face to face of y
    tilted.point = {0, 0.3, 0};
    tilted.normal = Vector3d(0, 1, 1).normalized();
    CHECK(area(triangles(tilted)) == about(0.1 * 0.6 * std::sqrt(2.0)));
    scene::PlaneShape corner; // cuts three edges of one corner, 0.05 m from it
    corner.point = {0.05, 0.6, 0.25};
    corner.normal = -Vector3d(1, 1, 1).normalized();
    CHECK(area(triangles(corner)) == about(std::sqrt(3.0) / 4 * 2 * 0.05 * 0.05));
}

TEST_CASE("a box has its closed faces, cut where it goes on periodically") {
    scene::BoxShape box;
    box.box = {Vector3d(-1, 0.1, -0.2), Vector3d(1, 0.3, 0.2)};
    box.open = {true, true, false, true, false, false}; // no x faces, no lid
    CHECK(area(triangles(box)) == about(0.1 * (0.4 + 0.2 + 0.2)));
    CHECK(area(triangles(box, {false, false, false})) == about(2 * (0.4 + 0.2 + 0.2)));
}

TEST_CASE("a cylinder, a disc and a ring have the areas of their 64 strips") {
    scene::CylinderShape cylinder;
    cylinder.axis = Vector3d(1, 2, 3).normalized();
    cylinder.length = 0.2;
    cylinder.radius = 0.1;
    CHECK(area(triangles(cylinder)) == about(2 * std::numbers::pi * 0.1 * 0.2 * chord_share(64)));
    scene::DiscShape disc;
    disc.normal = Vector3d(0, 1, 1).normalized();
    disc.radius = 0.1;
    const double full = std::numbers::pi * 0.01 * chord_share(32); // sin(2 pi/n) n/2 r^2
    CHECK(area(triangles(disc)) == about(full));
    disc.hole_radius = 0.05;
    CHECK(area(triangles(disc)) == about(0.75 * full));
    for (const Vector3d& vertex : triangles(disc).vertices)
        CHECK(std::abs(disc.normal.dot(vertex)) < 1e-15);
}

TEST_CASE("a trough runs from rim to rim, through its lowest point, tangent where sides begin") {
    scene::TroughShape trough;
    trough.radius = 0.2;
    trough.floor = 0.05;
    trough.rim = 0.5;
    trough.flare = 10 * std::numbers::pi / 180;
    const observe::FrameWall wall = triangles(trough);
    const auto by = [&](int axis, bool largest) {
        double best = wall.vertices.front()[axis];
        for (const Vector3d& v : wall.vertices)
            best = largest ? std::max(best, v[axis]) : std::min(best, v[axis]);
        return best;
    };
    CHECK(by(1, false) == about(0.05));
    CHECK(by(1, true) == about(0.5));
    CHECK(by(0, false) == -0.05); // the domain's length where the scene gives none
    CHECK(by(0, true) == 0.05);
    // Side: from (R cos f, c - R sin f) upwards, leaning outwards by f.
    const double f = trough.flare;
    const double rim = 0.2 * std::cos(f) + (0.5 - (0.25 - 0.2 * std::sin(f))) * std::tan(f);
    CHECK(by(2, true) == about(rim));
    CHECK(by(2, false) == about(-rim));
    const double side = (0.5 - (0.25 - 0.2 * std::sin(f))) / std::cos(f);
    const double arc = 2 * 0.2 * (std::numbers::pi / 2 - f);
    const double step = (std::numbers::pi / 2 - f) / 16; // angle of one of 32 chords
    CHECK(area(wall) == about(0.1 * (2 * side + arc * std::sin(step / 2) / (step / 2))));
    SUBCASE("a rim below the sides cuts the arc") {
        trough.rim = 0.15; // halfway up the circle: 60 degrees
        const observe::FrameWall cut = triangles(trough);
        double highest = 0;
        for (const Vector3d& v : cut.vertices)
            highest = std::max(highest, v.y());
        CHECK(highest == about(0.15));
    }
}

TEST_CASE("a mesh keeps its triangles and shares corners") {
    scene::MeshShape mesh;
    const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 0, 1), d(1, 0, 1);
    mesh.triangles = {{a, b, c}, {b, d, c}};
    const observe::FrameWall wall = triangles(mesh);
    CHECK(wall.vertices.size() == 4);
    CHECK(area(wall) == about(1));
}

} // namespace test_wall_triangles
