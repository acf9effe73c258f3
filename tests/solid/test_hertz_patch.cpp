#include "about.h"
#include "solid/generate.h"
#include "solid/hertz_patch.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

namespace test_hertz_patch {

using namespace tumble;
using namespace tumble::solid;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

HexMesh bar() {
    const Prism shape{.length = 0.1, .side = 0.02, .corner = 0.004, .corner_cells = 2, .middle_cells = 6, .along = 40};
    return *mesh_of(shape, {});
}

/// A force on the side x = 0.01, where a body touches it at height y and off the middle by z.
Push on_side(const HexMesh& mesh, double y, double z, const Vector3d& force) {
    return moved_to(mesh, {0, {0.01, y, z}, force}, Vector3d::UnitX()).value();
}

Vector3d force_of(const std::vector<Push>& points) {
    Vector3d sum = Vector3d::Zero();
    for (const Push& point : points)
        sum += point.force;
    return sum;
}

Vector3d moment_of(const std::vector<Push>& points) {
    Vector3d sum = Vector3d::Zero();
    for (const Push& point : points)
        sum += point.point.cross(point.force);
    return sum;
}

} // namespace

TEST_CASE("a push is spread with Hertz' shares: force, moment, and how far from the middle it acts") {
    // Of a pressure (3 F / 2 pi a^2) sqrt(1 - r^2/a^2) half acts within a sqrt(1 - 0.5^(2/3)) = 0.608 a, and the mean
    // of r^2 over the force is 2/5 a^2 (the integral of 3 u^2 (1 - u^2) over u from 0 to 1). Five rings at the middle
    // of their shares miss the latter by 1 %.
    const HexMesh mesh = bar();
    const Vector3d force(-5, 1, 0.5);
    const double a = 0.0017;
    const Push push = on_side(mesh, 0.043, 0.001, force);
    const auto points = PatchSpreader(mesh).spread(push, Vector3d::UnitX(), a);
    REQUIRE(points.size() == 60);
    CHECK((force_of(points) - force).norm() < 1e-14);
    CHECK((moment_of(points) - push.point.cross(force)).norm() < 1e-15); // rounding of 5 N at 50 mm
    double squares = 0, inner = 0;
    for (const Push& point : points) {
        CHECK((point.force.normalized() - force.normalized()).norm() < 1e-14);
        CHECK(point.point.x() == about(0.01, 1e-12));
        const double r = (point.point - push.point).norm() / a, share = point.force.norm() / force.norm();
        CHECK(r < 1);
        squares += share * r * r;
        inner += r < 0.608 ? share : 0;
    }
    CHECK(squares == about(0.4, 0.012));
    CHECK(inner == about(0.5, 0.21)); // two or three of five rings
    CHECK(nodal_loads(mesh, points));

    const auto point = PatchSpreader(mesh).spread(push, Vector3d::UnitX(), 0);
    REQUIRE(point.size() == 1);
    CHECK(point[0].point == push.point);
}

TEST_CASE("at an edge a patch keeps force and moment, and nothing pulls") {
    const HexMesh mesh = bar();
    const PatchSpreader spreader(mesh);
    const Vector3d force(-5, 0, 0);
    for (const double z : {0.0095, 0.0099, 0.01}) {
        CAPTURE(z);
        const Push push = on_side(mesh, 0.043, z, force);
        const auto points = spreader.spread(push, Vector3d::UnitX(), 0.001);
        CHECK((force_of(points) - force).norm() < 1e-14);
        CHECK((moment_of(points) - push.point.cross(force)).norm() < 1e-15);
        for (const Push& point : points)
            CHECK(point.force.x() <= 0);
    }
    // Aslant over the edge: both sides bear half of it, and only the arms along the normal, within a, are shorter.
    const Vector3d normal = Vector3d(1, 0, 1).normalized();
    const Push edge = moved_to(mesh, {0, {0.01, 0.043, 0.01}, -5 * normal}, normal).value();
    const auto points = spreader.spread(edge, normal, 0.001);
    REQUIRE(points.size() == 60);
    CHECK((force_of(points) + 5 * normal).norm() < 1e-14);
    CHECK((moment_of(points) - edge.point.cross(-5 * normal)).norm() < 1e-15); // the arms lie along the force
    double on_x = 0;
    for (const Push& point : points)
        on_x += mesh.area_of(point.facet).normalized().x() > 0.9 ? point.force.norm() : 0;
    CHECK(on_x > 1.5);
    CHECK(on_x < 3.5);
}

TEST_CASE("on a round side a patch follows the surface, lower than its middle by no more than the arc") {
    const BoredCylinder tube{.length = 0.1,
                             .radius = 0.015,
                             .bore_radius = 0.005,
                             .shell = 0.0015,
                             .around = 120,
                             .along = 40,
                             .shell_rings = 1,
                             .inner_rings = 2};
    const HexMesh mesh = *mesh_of(tube, {});
    const Push push = moved_to(mesh, {0, {0.015, 0.05, 0}, {-5, 0, 0}}, Vector3d::UnitX()).value();
    const double a = 0.0015;
    const auto points = PatchSpreader(mesh).spread(push, Vector3d::UnitX(), a);
    REQUIRE(points.size() == 60);
    Vector3d middle = Vector3d::Zero();
    for (const Push& point : points) {
        CHECK(point.point.head<1>().norm() > 0);
        CHECK(std::hypot(point.point.x(), point.point.z()) == about(0.015, 1e-3)); // the polygon's sagitta: 3.4e-4
        middle += point.force.norm() / 5 * point.point;
    }
    CHECK(middle.y() == about(0.05, 1e-12));
    CHECK(std::abs(middle.z() - push.point.z()) < 1e-15);
    CHECK(push.point.x() - middle.x() > 0);
    CHECK(push.point.x() - middle.x() < a * a / (2 * 0.015));
}

} // namespace test_hertz_patch
