#include "about.h"
#include "scene/bowl_mesh.h"
#include "scene/extent.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <numbers>

namespace test_bowl_mesh {

using namespace tumble;
using namespace tumble::scene;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

BowlShape bowl(int ribs) {
    return {Vector3d(0.01, -0.02, 0.03), 0.1665, 0.21, 0.25, {ribs, 0.004, 0.012, 0.006}};
}

BowlDiscShape disc(int ribs) {
    return {Vector3d(0.01, -0.02, 0.03), 0.1645, 0.03, 0.03, 0.25, {ribs, 0.004, 0.012, 0.006}};
}

using Corner = std::array<double, 3>;

/// How often the edges are walked from one corner to the other. Corners are compared exactly: one place, one number.
std::map<std::pair<Corner, Corner>, int> walks_of(const MeshShape& mesh) {
    std::map<std::pair<Corner, Corner>, int> walks;
    const auto corner = [](const Vector3d& v) { return Corner{v.x(), v.y(), v.z()}; };
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++walks[{corner(triangle[k]), corner(triangle[(k + 1) % 3])}];
    return walks;
}

/// Checks that the mesh is one sheet, turned one way, and returns the corners of edges that have one triangle only.
std::vector<Corner> rim_of(const MeshShape& mesh) {
    std::vector<Corner> rim;
    const auto walks = walks_of(mesh);
    for (const auto& [edge, count] : walks) {
        CHECK(count == 1);
        if (!walks.contains({edge.second, edge.first}))
            rim.push_back(edge.first);
    }
    return rim;
}

double area_of(const MeshShape& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += (b - a).cross(c - a).norm() / 2;
    return area;
}

Vector3d normal_of(const std::array<Vector3d, 3>& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
}

} // namespace

TEST_CASE("the bowl's wall is one sheet that ends at its upper and lower edge only, on the circle or a rib's crest") {
    for (const int ribs : {0, 5, 12, 24}) {
        CAPTURE(ribs);
        const BowlShape shape = bowl(ribs);
        for (const Corner& at : rim_of(mesh_of(shape))) {
            const bool below = std::abs(at[1] + 0.02) < 1e-12, above = std::abs(at[1] - 0.19) < 1e-12;
            CHECK((below || above));
            const double radius = std::hypot(at[0] - 0.01, at[2] - 0.03);
            CHECK(radius < 0.1665 + 1e-12);
            CHECK(radius > 0.1665 - 0.0043); // rib and the sagitta of its chord, 0.11 mm
        }
    }
}

TEST_CASE("the bowl's disc is one sheet that ends at the rim's edge") {
    for (const int ribs : {0, 3, 8, 12}) {
        CAPTURE(ribs);
        const auto rim = rim_of(mesh_of(disc(ribs)));
        CHECK(rim.size() > 60);
        for (const Corner& at : rim) {
            CHECK(at[1] == about(0.01));
            CHECK(std::hypot(at[0] - 0.01, at[2] - 0.03) == about(0.1645, 0.002));
        }
    }
}

TEST_CASE("without ribs wall and rim are prism and frustum of as many corners as facets of 4 degrees need") {
    const int n = 90;
    const double chords = std::sin(pi / n) / (pi / n), apothems = std::cos(pi / n);
    CHECK(area_of(mesh_of(bowl(0))) == about(2 * pi * 0.1665 * 0.21 * chords, 1e-12));
    const double flat = pi * 0.1345 * 0.1345 * chords * apothems;
    const double rim = pi * (0.1345 + 0.1645) * chords * std::hypot(0.03, 0.03 * apothems);
    CHECK(area_of(mesh_of(disc(0))) == about(flat + rim, 1e-12));
}

TEST_CASE("every normal of the wall points inwards, every normal of the disc upwards") {
    for (const int ribs : {0, 12}) {
        for (const auto& triangle : mesh_of(bowl(ribs)).triangles) {
            const Vector3d middle = (triangle[0] + triangle[1] + triangle[2]) / 3 - Vector3d(0.01, 0, 0.03);
            CHECK(normal_of(triangle).dot(Vector3d(middle.x(), 0, middle.z())) < 1e-9);
        }
        for (const auto& triangle : mesh_of(disc(ribs)).triangles)
            CHECK(normal_of(triangle).y() > 0);
    }
}

TEST_CASE("a rib stands as high and as wide as it is said to, on wall, flat part and rim") {
    const Ribs& ribs = disc(12).ribs;
    const double foot = std::asin(0.006 / 0.1345), facet = 1.25 * foot;
    const double slope = std::atan2(0.03, 0.03 * std::cos(facet));
    int on_flat = 0, on_rim = 0;
    for (const auto& [a, b, c] : mesh_of(disc(12)).triangles)
        for (const Vector3d& corner : {a, b, c}) {
            const Vector3d at = corner - Vector3d(0.01, -0.02, 0.03);
            if (std::abs(at.z()) > ribs.width / 2 + 1e-9 || at.x() < 0)
                continue; // of the first rib, that lies along x
            const double off = std::abs(at.z());
            if (at.x() < 0.12 && at.y() > 1e-9) {
                CHECK(at.y() == about(ribs.height));
                CHECK(off == about(ribs.crest / 2));
                ++on_flat;
            }
            const double above_rim = (at.y() - (at.x() - 0.1345 * std::cos(facet)) * std::tan(slope)) * std::cos(slope);
            if (at.x() > 0.14 && above_rim > 1e-9) {
                CHECK(above_rim == about(ribs.height));
                CHECK(off == about(ribs.crest / 2));
                ++on_rim;
            }
        }
    CHECK(on_flat > 0);
    CHECK(on_rim > 0);
    double innermost = 1;
    for (const auto& triangle : mesh_of(bowl(12)).triangles)
        for (const Vector3d& corner : triangle)
            innermost = std::min(innermost, std::hypot(corner.x() - 0.01, corner.z() - 0.03));
    CHECK(innermost == about(std::hypot(std::sqrt(0.1665 * 0.1665 - 0.006 * 0.006) - 0.004, 0.003)));
}

TEST_CASE("the extent said of a bowl is that of its triangles") {
    for (const WallShape& shape : {WallShape(bowl(0)), WallShape(bowl(12)), WallShape(disc(0)), WallShape(disc(12))}) {
        const MeshShape mesh = std::holds_alternative<BowlShape>(shape) ? mesh_of(std::get<BowlShape>(shape))
                                                                        : mesh_of(std::get<BowlDiscShape>(shape));
        const Box said = extent_of(shape), is = extent_of(WallShape(mesh));
        CHECK((said.lo - is.lo).norm() < 5e-4); // a facet with a rib lies up to 0.26 mm inside the circle
        CHECK((said.hi - is.hi).norm() < 5e-4);
    }
}

TEST_CASE("what cannot be built is named by its key") {
    BowlShape wide = bowl(12);
    wide.ribs.width = 0.1;
    CHECK(fault_of(wide)->key == "rib_width_m");
    BowlDiscShape crowded = disc(12);
    crowded.rib_start = 0.02;
    CHECK(fault_of(crowded)->key == "rib_width_m");
    BowlDiscShape late = disc(12);
    late.rib_start = 0.9;
    CHECK(fault_of(late)->key == "rib_start");
    BowlDiscShape pointed = disc(12);
    pointed.ribs.crest = 0.02;
    CHECK(fault_of(pointed)->key == "rib_crest_m");
    BowlDiscShape no_floor = disc(0);
    no_floor.rim_width = 0.2;
    CHECK(fault_of(no_floor)->key == "rim_width_m");
    BowlShape filled = bowl(12);
    filled.ribs.height = 0.2;
    CHECK(fault_of(filled)->key == "rib_height_m");
    CHECK(fault_of(filled)->fix.starts_with("make them lower than 0.1575 m, ")); // of 0.21 m the upper three quarters
    BowlDiscShape steep = disc(12);
    steep.ribs.height = 0.016; // on a rim of 0.03 m
    CHECK(fault_of(steep)->key == "rib_height_m");
    steep.rim_width = 0.05;
    CHECK(!fault_of(steep));
    steep.rib_start = 0.55; // 0.0905 of 0.1145 m: 0.024 m of floor
    CHECK(fault_of(steep)->fix == "make them lower than 0.01201 m, or let them begin farther in (rib_start)");
    for (const int ribs : {0, 12}) {
        CHECK(!fault_of(bowl(ribs)));
        CHECK(!fault_of(disc(ribs)));
    }
}

} // namespace test_bowl_mesh
