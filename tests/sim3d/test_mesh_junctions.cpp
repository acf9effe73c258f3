#include "about.h"
#include "sim3d/meshes.h"

#include <doctest/doctest.h>

namespace test_mesh_junctions {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

TEST_CASE("where one long edge meets several short ones there is no edge in a plane, and one edge on a crease") {
    Rng rng(16);
    const double radius = 0.05;
    Triangles floor; // three sheets side by side, of one, seven and three quads along the seam
    add_sheet(floor, Vector3d(-0.5, 0, -0.5), Vector3d(0.5, 0, 0), Vector3d(0, 0, 1), 1, 1, rng);
    add_sheet(floor, Vector3d(0, 0, -0.5), Vector3d(0.2, 0, 0), Vector3d(0, 0, 1), 2, 7, rng);
    add_sheet(floor, Vector3d(0.2, 0, -0.5), Vector3d(0.3, 0, 0), Vector3d(0, 0, 1), 1, 3, rng);
    const WallSurface flat = surface_of(floor);
    const int feature = touches(flat, Vector3d(-0.2, 0.04, 0), radius).at(0).feature;
    for (int i = 0; i < 3000; ++i) {
        const double x = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 0.2 : rng.uniform(-0.3, 0.3);
        const Vector3d centre(x, radius * rng.uniform(0.5, 0.99), rng.uniform(-0.4, 0.4));
        const auto found = touches(flat, centre, radius);
        REQUIRE(found.size() == 1);
        CHECK(found[0].feature == feature);
        CHECK((found[0].normal - Vector3d::UnitY()).norm() < 1e-12);
        CHECK(std::abs(found[0].gap - (centre.y() - radius)) < 1e-12);
    }
    Triangles block = box_mesh(Vector3d(-0.3, -0.3, -0.3), Vector3d(0.3, 0.3, 0.3), 1, rng);
    block.erase(std::remove_if(block.begin(), block.end(),
                               [](const auto& t) { return t[0].y() > 0 && t[1].y() > 0 && t[2].y() > 0; }),
                block.end());
    add_sheet(block, Vector3d(-0.3, 0.3, -0.3), Vector3d(0.6, 0, 0), Vector3d(0, 0, 0.6), 5, 3, rng); // its lid
    const WallSurface closed = surface_of(block);
    for (int i = 0; i < 3000; ++i) {
        const Vector3d edge(0.3, 0.3, rng.uniform(-0.25, 0.25));
        const double angle = rng.uniform(-0.3, 0.5 * pi + 0.3), far = radius * rng.uniform(0.5, 0.99);
        const auto found = touches(closed, edge + far * Vector3d(std::cos(angle), std::sin(angle), 0), radius);
        REQUIRE(found.size() == 1);
        const double nearest = angle < 0 ? far * std::cos(angle) : angle > pi / 2 ? far * std::sin(angle) : far;
        CHECK(std::abs(found[0].gap - (nearest - radius)) < 1e-12);
    }
}

TEST_CASE("sheets cut otherwise on the two ends of a period go on without an edge") {
    Rng rng(17);
    Triangles triangles;
    add_sheet(triangles, Vector3d(-1, 0, -1), Vector3d(1, 0, 0), Vector3d(0, 0, 2), 2, 5, rng);
    add_sheet(triangles, Vector3d(0, 0, -1), Vector3d(1, 0, 0), Vector3d(0, 0, 2), 2, 3, rng);
    const WallSurface sheet = surface_of(triangles, {true, false, false});
    const int feature = touches(sheet, Vector3d(0.5, 0.04, 0), 0.05).at(0).feature;
    for (int i = 0; i < 2000; ++i) {
        const double x = (i % 2 == 0 ? 1.0 : -1.0) + (i % 4 < 2 ? 0.0 : rng.uniform(-0.03, 0.03));
        const auto found = touches(sheet, Vector3d(x, 0.04, rng.uniform(-0.9, 0.9)), 0.05);
        REQUIRE(found.size() == 1);
        CHECK(found[0].feature == feature);
    }
}

} // namespace test_mesh_junctions
