#include "about.h"
#include "solid/generate.h"
#include "solid/hertz_patch.h"

#include <Eigen/Geometry>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <string>

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
    // Of a pressure (3 F / 2 pi a^2) sqrt(1 - r^2/a^2) lies 1 - (1 - 0.6^2)^(3/2) = 0.488 within 0.6 a, where the third
    // of five rings ends. Over the force, which is 3 u sqrt(1 - u^2) du, the mean of r is 3 pi / 16 a and that of r^2
    // 2/5 a^2, of which rings of a width of a fifth miss what r scatters in each, (1/5)^2 / 12 a^2.
    const HexMesh mesh = bar();
    const Vector3d force(-5, 1, 0.5);
    const double a = 0.0017;
    const Push push = on_side(mesh, 0.043, 0.001, force);
    const auto points = PatchSpreader(mesh).spread(push, Vector3d::UnitX(), a);
    REQUIRE(points.size() >= 60);
    CHECK((force_of(points) - force).norm() < 1e-14);
    CHECK((moment_of(points) - push.point.cross(force)).norm() < 1e-15); // rounding of 5 N at 50 mm
    double first = 0, squares = 0, inner = 0;
    for (const Push& point : points) {
        CHECK((point.force.normalized() - force.normalized()).norm() < 1e-14);
        CHECK(point.point.x() == about(0.01, 1e-12));
        const double r = (point.point - push.point).norm() / a, share = point.force.norm() / force.norm();
        CHECK(r < 1);
        first += share * r;
        squares += share * r * r;
        inner += r < 0.6 ? share : 0;
    }
    CHECK(first == about(3 * std::numbers::pi / 16, 1e-10));
    CHECK(squares == about(0.4 - 0.04 / 12, 0.002));
    CHECK(inner == about(0.488, 1e-10));
    CHECK(nodal_loads(mesh, points));

    const auto point = PatchSpreader(mesh).spread(push, Vector3d::UnitX(), 0);
    REQUIRE(point.size() == 1);
    CHECK(point[0].point == push.point);
}

TEST_CASE("on facets of a sixth of its radius a patch's nodal loads are Hertz' pressure over each node's share") {
    // A node's load over the facets' h^2 is the pressure averaged with the node's shape functions, whose variance is
    // h^2 / 6 along either side: p + h^2 / 12 (p_yy + p_zz), with p = p0 sqrt(1 - q^2), q = r / a, and p_yy + p_zz =
    // -p0 / a^2 (2 - q^2) / (1 - q^2)^(3/2).
    const HexMesh mesh = *mesh_of(
        Prism{.length = 0.005, .side = 0.005, .corner = 0.00125, .corner_cells = 5, .middle_cells = 10, .along = 20},
        {});
    const double h = 0.00025, a = 6 * h, force = 5;
    for (const double off : {0.0, 0.3}) { // of a facet, from a node
        CAPTURE(off);
        const Push push =
            moved_to(mesh, {0, {0.0025, 0.0025 + off * h, 0.7 * off * h}, {-force, 0, 0}}, Vector3d::UnitX()).value();
        const auto points = PatchSpreader(mesh).spread(push, Vector3d::UnitX(), a);
        // 18 rings, three to a facet: their points fill the circle evenly.
        CHECK(static_cast<double>(points.size()) == about(std::numbers::pi * 18 * 18, 0.01));
        const Eigen::Matrix3Xd loads = nodal_loads(mesh, points).value();
        const double p0 = 3 * force / (2 * std::numbers::pi * a * a);
        double worst = 0;
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
            const double q = (mesh.nodes[node] - push.point).norm() / a;
            if (mesh.nodes[node].x() < 0.0025 || q > 0.7)
                continue;
            const double u = 1 - q * q;
            const double expected = p0 * (std::sqrt(u) - h * h / (12 * a * a) * (1 + u) / std::pow(u, 1.5));
            worst = std::max(worst, std::abs(-loads(0, static_cast<Eigen::Index>(node)) / (h * h) / expected - 1));
        }
        CHECK(worst < 0.04);
    }
}

TEST_CASE("at an edge a patch keeps force and moment and its length along the edge, and presses on nothing beyond") {
    const HexMesh mesh = bar();
    const PatchSpreader spreader(mesh);
    const Vector3d force(-5, 0, 0);
    const double a = 0.001;
    for (const double d : {0.5, 0.1, 0.0}) { // radii from the edge at z = 10 mm
        CAPTURE(d);
        const Push push = on_side(mesh, 0.043, 0.01 - d * a, force);
        const auto points = spreader.spread(push, Vector3d::UnitX(), a);
        REQUIRE(points.size() >= 60);
        CHECK((force_of(points) - force).norm() < 1e-14);
        CHECK((moment_of(points) - push.point.cross(force)).norm() < 1e-15);
        double along = 0, across = 0; // means of the squares, radii^2
        for (const Push& point : points) {
            CHECK(point.force.x() < 0);
            CHECK(point.point.x() == about(0.01, 1e-12));
            CHECK(std::abs(point.point.z() - push.point.z()) < d * a + 1e-15);
            const Vector3d off = (point.point - push.point) / a;
            along += point.force.norm() / 5 * off.y() * off.y();
            across += point.force.norm() / 5 * off.z() * off.z();
        }
        // Strips of Hertz' pressure bear 3/4 (1 - x^2) dx of the force: the mean of x^2 is 1/5, and where those beyond
        // d count as d it is 3/2 (d^3/3 - d^5/5 + d^2 (2/3 - d + d^3/3)).
        CHECK(along == about(0.2 - 0.02 / 12, 0.002)); // but for what r scatters in a ring, as above
        const double clipped =
            1.5 * (std::pow(d, 3) / 3 - std::pow(d, 5) / 5 + d * d * (2.0 / 3 - d + std::pow(d, 3) / 3));
        CHECK(std::abs(across - clipped) <= 0.05 * clipped + 1e-15);
    }
    SUBCASE("at a corner nothing is left but the point, and of a part narrower than the patch its width") {
        const Push corner = on_side(mesh, 0.1, 0.01, force);
        const auto points = spreader.spread(corner, Vector3d::UnitX(), a);
        CHECK((force_of(points) - force).norm() < 1e-14);
        for (const Push& point : points)
            CHECK((point.point - corner.point).norm() < 1e-15);
        const Push wide = on_side(mesh, 0.05, 0.004, force);
        const auto clipped = spreader.spread(wide, Vector3d::UnitX(), 0.018);
        CHECK((force_of(clipped) - force).norm() < 1e-12); // of 1800 points
        CHECK((moment_of(clipped) - wide.point.cross(force)).norm() < 2e-15);
        for (const Push& point : clipped)
            CHECK(std::abs(point.point.z() - 0.004) < 0.006 + 1e-15);
    }
    SUBCASE("aslant over the edge both sides bear half of it") {
        const Vector3d normal = Vector3d(1, 0, 1).normalized();
        const Push edge = moved_to(mesh, {0, {0.01, 0.043, 0.01}, -5 * normal}, normal).value();
        const auto points = spreader.spread(edge, normal, a);
        REQUIRE(points.size() >= 60);
        CHECK((force_of(points) + 5 * normal).norm() < 1e-14);
        CHECK((moment_of(points) - edge.point.cross(-5 * normal)).norm() < 1e-15); // the arms lie along the force
        double on_x = 0;
        for (const Push& point : points)
            on_x += mesh.area_of(point.facet).normalized().x() > 0.9 ? point.force.norm() : 0;
        CHECK(on_x == about(2.5, 0.1)); // but for points on the edge itself
    }
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
    REQUIRE(points.size() >= 60);
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

    // On the flat end, 0.3 radii inside of the round edge: wide along the edge, not beyond it, and in balance.
    const Push end = moved_to(mesh, {0, {0.015 - 0.3 * a, 0, 0.0001}, {1, 5, 0}}, -Vector3d::UnitY()).value();
    const auto at_edge = PatchSpreader(mesh).spread(end, -Vector3d::UnitY(), a);
    CHECK((force_of(at_edge) - end.force).norm() < 1e-13);
    CHECK((moment_of(at_edge) - end.point.cross(end.force)).norm() < 1e-15);
    double along = 0, across = 0;
    for (const Push& point : at_edge) {
        CHECK(point.point.y() == 0);
        CHECK(point.point.head<3>().norm() < 0.015 + 1e-12);
        along += point.force.norm() / end.force.norm() * std::pow((point.point.z() - 0.0001) / a, 2);
        across += point.force.norm() / end.force.norm() * std::pow((point.point.x() - end.point.x()) / a, 2);
    }
    CHECK(along < 0.2); // all of Hertz' where the edge is straight
    CHECK(along > 0.05);
    CHECK(across < 0.3 * 0.3);
}

TEST_CASE(
    "an oblique force on what is not flat keeps its moment about the contact, and presses wherever it is spread") {
    // Across an edge of 90 degrees at 45 a point x from the edge lies |x| lower than the contact, 3/8 a in the mean
    // (strips of Hertz' pressure bear 3/4 (1 - x^2 / a^2) dx / a of the force): shear of 0.34 F would miss
    // 0.34 x 3/8 a F of its moment. The pressure leans to bear that, by 0.34 (3/8) / (1/5) = 0.64 of itself at the rim.
    const HexMesh prism = bar();
    const HexMesh tube = *mesh_of(BoredCylinder{.length = 0.1,
                                                .radius = 0.015,
                                                .bore_radius = 0.005,
                                                .shell = 0.0015,
                                                .around = 120,
                                                .along = 40,
                                                .shell_rings = 1,
                                                .inner_rings = 2},
                                  {});
    struct Place {
        std::string what;
        const HexMesh& mesh;
        Vector3d at, normal;
    };
    const double a = 0.0008;
    for (const auto& [what, mesh, at, normal] :
         {Place{"edge", prism, {0.01, 0.043, 0.01}, Vector3d(1, 0, 1).normalized()},
          Place{"beside the edge", prism, {0.01, 0.043, 0.0099}, Vector3d(1, 0, 1).normalized()},
          Place{"lower rim", tube, {0.015, 0, 0.0002}, Vector3d(1, -1, 0).normalized()},
          Place{"round side", tube, {0.015, 0.051, 0.0003}, Vector3d::UnitX()}})
        for (const double shear : {0.34, 1.0, 20.0})
            for (const double along : {0.0, 0.7, 1.0}) {
                CAPTURE(what);
                CAPTURE(shear);
                CAPTURE(along);
                const Vector3d one = normal.unitOrthogonal();
                const Vector3d way = along * one + std::sqrt(1 - along * along) * normal.cross(one);
                for (const double press : {5.0, -0.1}) { // N; the second pulls, as a dashpot does
                    const Vector3d force = press * (shear * way - normal);
                    const Push push = moved_to(mesh, {0, at, force}, normal).value();
                    const auto points = PatchSpreader(mesh).spread(push, normal, a);
                    CHECK(points.size() >= 60);
                    const double size = force.norm();
                    CHECK((force_of(points) - force).norm() < 1e-14 * size);
                    Vector3d moment = Vector3d::Zero(); // about the contact
                    for (const Push& point : points) {
                        moment += (point.point - push.point).cross(point.force);
                        CHECK(press * point.force.dot(normal) < 1e-15 * size); // all press, or all pull
                    }
                    CHECK(moment.norm() < 1e-12 * a * size);
                    const Eigen::Matrix3Xd loads = nodal_loads(mesh, points).value();
                    CHECK_FALSE(imbalance(mesh, loads, {push}));
                    // What is not the contact's is seen: its force a twentieth of the patch deeper misses 0.05 a F.
                    Push lower = push;
                    lower.point -= 0.05 * a * normal;
                    const auto problem = imbalance(mesh, loads, {lower});
                    REQUIRE(problem);
                    CHECK(problem->what.starts_with("forces on the nodes miss"));
                }
            }
}

TEST_CASE("at an edge that is seen from one side alone, what no width can bear of a shear force acts at the contact") {
    // A body at the lower rim, straight from the side: the patch is a line along the rim, which is round, so that its
    // points lie lower than the contact. Shear along the line leans along it; shear across has nothing to lean on.
    const HexMesh tube = *mesh_of(BoredCylinder{.length = 0.1,
                                                .radius = 0.015,
                                                .bore_radius = 0.005,
                                                .shell = 0.0015,
                                                .around = 120,
                                                .along = 40,
                                                .shell_rings = 1,
                                                .inner_rings = 2},
                                  {});
    const double a = 0.0015;
    const Push push = moved_to(tube, {0, {0.015, 0, 0.0003}, {-5, 1.2, 0.9}}, Vector3d::UnitX()).value();
    const auto points = PatchSpreader(tube).spread(push, Vector3d::UnitX(), a);
    CHECK(points.size() >= 60);
    CHECK((force_of(points) - push.force).norm() < 1e-14);
    Vector3d moment = Vector3d::Zero();
    double across = 0; // N, at the contact itself
    for (const Push& point : points) {
        moment += (point.point - push.point).cross(point.force);
        CHECK(point.force.x() <= 0);
        if (point.point == push.point)
            across += point.force.y();
    }
    CHECK(moment.norm() < 1e-12 * a * 5);
    CHECK(across == about(1.2, 1e-6));
}

} // namespace test_hertz_patch
