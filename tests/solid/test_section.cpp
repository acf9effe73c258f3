#include "about.h"
#include "solid/generate.h"
#include "solid/section.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

namespace test_section {

using namespace tumble;
using namespace tumble::solid;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

const Prism bar{.length = 0.1, .side = 0.02, .corner = 0.004, .corner_cells = 2, .middle_cells = 3, .along = 5};

double area_of(const Section& section, const HexMesh& mesh) {
    double area = 0;
    for (const auto& triangle : section.triangles) {
        std::array<Vector3d, 3> at;
        for (std::size_t k = 0; k < 3; ++k)
            at[k] = section.points[static_cast<std::size_t>(triangle[k])].of(mesh.nodes);
        area += 0.5 * (at[1] - at[0]).cross(at[2] - at[0]).norm();
    }
    return area;
}

} // namespace

TEST_CASE("a plane across a bar cuts its square, aslant a longer one, and along it its side's rectangle") {
    const HexMesh mesh = *mesh_of(bar, {});
    const double square = 0.02 * 0.02;
    CHECK(area_of(section_of(mesh, {0, 0.033, 0}, Vector3d::UnitY()), mesh) == about(square, 1e-12));
    // By 1 / cos of the angle between its normal and the bar.
    const Vector3d aslant = Vector3d(1, 2, 0).normalized();
    CHECK(area_of(section_of(mesh, {0, 0.05, 0}, aslant), mesh) == about(square / aslant.y(), 1e-12));
    CHECK(area_of(section_of(mesh, {0.003, 0, 0}, Vector3d::UnitX()), mesh) == about(0.1 * 0.02, 1e-12));
    // Through nodes: a layer of them, and the bar's own middle.
    CHECK(area_of(section_of(mesh, {0, 0.04, 0}, Vector3d::UnitY()), mesh) == about(square, 1e-12));
}

TEST_CASE("a bored cylinder's cut across is its polygon without the bore's") {
    const BoredCylinder part{.length = 0.1,
                             .radius = 0.015,
                             .bore_radius = 0.005,
                             .shell = 0.0015,
                             .around = 24,
                             .along = 3,
                             .shell_rings = 2,
                             .inner_rings = 2};
    const HexMesh mesh = *mesh_of(part, {});
    // Of a polygon of n corners on a circle: n / 2 r^2 sin(2 pi / n).
    const double share = 12 * std::sin(2 * EIGEN_PI / 24);
    CHECK(area_of(section_of(mesh, {0, 0.05, 0}, Vector3d::UnitY()), mesh) ==
          about(share * (0.015 * 0.015 - 0.005 * 0.005), 1e-12));
}

TEST_CASE("a plane that passes by cuts nothing") {
    const Section section = section_of(*mesh_of(bar, {}), {0, 0.2, 0}, Vector3d::UnitY());
    CHECK(section.points.empty());
    CHECK(section.triangles.empty());
    CHECK(section.lines.empty());
}

TEST_CASE("what is linear in space is found exactly at a cut's points, and its lines lie in the plane") {
    const HexMesh mesh = *mesh_of(bar, {});
    const Vector3d slope(3, -2, 5), normal = Vector3d(1, 1, -1).normalized(), through(0.001, 0.05, 0);
    std::vector<double> values;
    for (const Vector3d& node : mesh.nodes)
        values.push_back(slope.dot(node) + 1);
    const Section section = section_of(mesh, through, normal);
    REQUIRE(section.lines.size() > 20);
    double off = 0, out = 0;
    for (const CutPoint& point : section.points) {
        const Vector3d place = point.of(mesh.nodes);
        off = std::max(off, std::abs(point.of(values) - slope.dot(place) - 1));
        out = std::max(out, std::abs(normal.dot(place - through)));
    }
    CHECK(off < 1e-14);
    CHECK(out < 1e-15);
}

} // namespace test_section
