#include "about.h"
#include "base/rng.h"
#include "solid/facet_load.h"
#include "solid/generate.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

namespace test_facet_load {

using namespace tumble;
using namespace tumble::solid;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

HexMesh cylinder() {
    const BoredCylinder part{.length = 0.1,
                             .radius = 0.015,
                             .bore_radius = 0.005,
                             .shell = 0.0015,
                             .around = 20,
                             .along = 4,
                             .shell_rings = 1,
                             .inner_rings = 2};
    return *mesh_of(part, {{0.01, 0.02, 0.03}, Vector3d(0.6, 0.8, 0)});
}

} // namespace

TEST_CASE("nodal loads have the force and the moment of the contacts") {
    const HexMesh mesh = cylinder();
    const auto triangles = triangles_of(mesh);
    Rng rng(3);
    std::vector<Push> pushes;
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (int k = 0; k < 500; ++k) {
        const auto triangle = static_cast<std::size_t>(rng.uniform() * static_cast<double>(triangles.size()));
        double a = rng.uniform(), b = rng.uniform();
        if (a + b > 1)
            a = 1 - a, b = 1 - b;
        const auto& [p, q, r] = triangles[triangle];
        const Vector3d point = p + a * (q - p) + b * (r - p);
        const Vector3d push(rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5);
        pushes.push_back({static_cast<int>(triangle / 2), point, push});
        force += push;
        moment += point.cross(push);
    }
    const auto loads = nodal_loads(mesh, pushes);
    REQUIRE(loads);
    Vector3d nodal_force = Vector3d::Zero(), nodal_moment = Vector3d::Zero();
    for (Eigen::Index n = 0; n < loads->cols(); ++n) {
        nodal_force += loads->col(n);
        nodal_moment += mesh.nodes[static_cast<std::size_t>(n)].cross(Vector3d(loads->col(n)));
    }
    CHECK((nodal_force - force).norm() < 1e-12 * 500);
    CHECK((nodal_moment - moment).norm() < 1e-13 * 500); // arms of 0.1 m
}

TEST_CASE("a facet that is not flat takes a force on either of its triangles with its moment, exactly") {
    // A corner of the unit cube is drawn in by a tenth, so that three of its facets are curved by 0.1 m.
    HexMesh cube;
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
            cube.nodes.emplace_back(x, y, z);
    cube.nodes[6] = Vector3d(0.9, 0.9, 0.9);
    cube.hexes = {{0, 1, 2, 3, 4, 5, 6, 7}};
    const HexMesh mesh = *finished(cube);
    const auto triangles = triangles_of(mesh);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        CAPTURE(t);
        const auto& [p, q, r] = triangles[t];
        const Vector3d point = 0.2 * p + 0.3 * q + 0.5 * r, force(1, -2, 3);
        const auto loads = nodal_loads(mesh, {{static_cast<int>(t / 2), point, force}});
        REQUIRE_MESSAGE(loads, to_string(loads.problems()));
        Vector3d moment = Vector3d::Zero();
        for (Eigen::Index n = 0; n < 8; ++n)
            moment += mesh.nodes[static_cast<std::size_t>(n)].cross(Vector3d(loads->col(n)));
        CHECK((loads->rowwise().sum() - force).norm() < 1e-14);
        CHECK((moment - point.cross(force)).norm() < 1e-14);
    }
}

TEST_CASE("a force at a corner goes to that node alone, one in the middle to all four alike") {
    const HexMesh mesh = cylinder();
    const int corner = mesh.facets[7].corners[2];
    const auto at_corner = shares_at(mesh, 7, mesh.nodes[static_cast<std::size_t>(corner)]);
    CHECK((at_corner - Eigen::Vector4d(0, 0, 1, 0)).norm() < 1e-12);
    const auto in_middle =
        shares_at(mesh, mesh.facet_sets.at("side")[0], mesh.centre_of(mesh.facet_sets.at("side")[0]));
    CHECK((in_middle - Eigen::Vector4d::Constant(0.25)).norm() < 1e-12);
}

TEST_CASE("on another mesh of the same part a push keeps its place, on a finer polygon to within its sagitta") {
    const Prism bar{.length = 0.1, .side = 0.02, .corner = 0.004, .corner_cells = 1, .middle_cells = 1, .along = 2};
    Prism finer = bar;
    finer.middle_cells = 7;
    finer.along = 13;
    const HexMesh mesh = *mesh_of(finer, {});
    const Push push{0, {0.01, 0.0431, -0.0017}, {-3, 1, 0}};
    const auto moved = moved_to(mesh, push, Vector3d::UnitX());
    REQUIRE(moved);
    CHECK((moved->point - push.point).norm() < 1e-15);
    CHECK(moved->force == push.force);
    CHECK(mesh.area_of(moved->facet).normalized().dot(Vector3d::UnitX()) == about(1, 1e-12));
    // At an edge a body touches under 45 degrees to both sides, at a corner under 54.7 to all three.
    for (const Vector3d& normal : {Vector3d(1, 0, 1), Vector3d(1, 1, 1)}) {
        const auto edge = moved_to(mesh, {0, {0.01, normal.y() > 0 ? 0.1 : 0.05, 0.01}, {}}, normal.normalized());
        REQUIRE(edge);
        CHECK((edge->point - Vector3d(0.01, normal.y() > 0 ? 0.1 : 0.05, 0.01)).norm() < 1e-15);
    }
    CHECK(!moved_to(HexMesh{}, push, Vector3d::UnitX()));

    const BoredCylinder tube{.length = 0.1,
                             .radius = 0.015,
                             .bore_radius = 0.005,
                             .shell = 0.0015,
                             .around = 48,
                             .along = 4,
                             .shell_rings = 1,
                             .inner_rings = 1};
    const HexMesh round = *mesh_of(tube, {});
    // In the middle of a side of a polygon of 24 corners, which the one of 48 has as a corner: r (1 - cos(pi / 24)).
    const double half = EIGEN_PI / 24, inner = 0.015 * std::cos(half);
    const Vector3d outward(std::sin(half), 0, std::cos(half));
    const auto shifted = moved_to(round, {0, Vector3d(0, 0.03, 0) + inner * outward, {}}, outward);
    REQUIRE(shifted);
    const double sagitta = 0.015 * (1 - std::cos(half));
    CHECK((shifted->point - Vector3d(0, 0.03, 0) - inner * outward).norm() < sagitta * (1 + 1e-12));
}

TEST_CASE("a contact that lies off its facet is a problem that names both gap and facet") {
    const HexMesh mesh = cylinder();
    const Vector3d off = mesh.centre_of(5) + 1e-4 * mesh.area_of(5).normalized();
    const auto loads = nodal_loads(mesh, {{5, off, Vector3d(1, 2, 3)}});
    REQUIRE_FALSE(loads);
    CHECK(loads.problems()[0].what.find("a contact lies 0.0001 m off facet 6 of element") != std::string::npos);
    CHECK_FALSE(nodal_loads(mesh, {{100000, off, Vector3d(1, 2, 3)}}));
}

} // namespace test_facet_load
