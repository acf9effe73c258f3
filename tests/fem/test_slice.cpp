#include "about.h"
#include "bricks.h"
#include "fem/slice.h"
#include "fem/vtu.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace test_slice {

using namespace tumble;
using namespace tumble::fem;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

solid::HexMesh tube() {
    const solid::BoredCylinder part{.length = 0.1,
                                    .radius = 0.015,
                                    .bore_radius = 0.005,
                                    .shell = 0.0015,
                                    .around = 12,
                                    .along = 4,
                                    .shell_rings = 3,
                                    .inner_rings = 2};
    return *solid::mesh_of(part, {{0.1, 0, 0}, Vector3d::UnitY()});
}

/// Nodal stresses from a field.
template <class Field> Eigen::VectorXd stresses(const solid::HexMesh& mesh, Field field) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(6 * mesh.nodes.size()));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        values.segment<6>(static_cast<Eigen::Index>(6 * n)) = field(mesh.nodes[n]);
    return values;
}

} // namespace

TEST_CASE("slices lie beneath every node of a side, as deep as asked, and look outwards") {
    const solid::HexMesh mesh = tube();
    const solid::Locator locator(mesh);
    const auto slice = slice_of(mesh, locator, "side", Vector3d::UnitY(), 0.001);
    REQUIRE_MESSAGE(slice, to_string(slice.problems()));
    REQUIRE(slice->points.size() == 12 * 5);
    double area = 0;
    for (const SlicePoint& point : slice->points) {
        const Vector3d arm = point.place - Vector3d(0.1, point.place.y(), 0);
        CHECK(arm.norm() == about(0.014, 1e-9));
        area += point.area;
        CHECK(point.directions.normal.dot(arm.normalized()) == about(1));
        CHECK((point.directions.along - Vector3d::UnitY()).norm() < 1e-12);
        CHECK((point.directions.contour - Vector3d::UnitY().cross(point.directions.normal)).norm() < 1e-12);
        CHECK(point.inside.shares.sum() == about(1));
        CHECK((mesh.corners_of(point.inside.hex) * point.inside.shares - point.place).norm() < 1e-12);
    }
    // Twelve facets a ring, each as wide as the chord over 30 degrees.
    CHECK(area == about(12 * 2 * 0.015 * std::sin(std::acos(-1.0) / 12) * 0.1, 1e-9));
    CHECK(slice_of(mesh, locator, "front", Vector3d::UnitY(), 0.001).problems().at(0).fix ==
          "it has base, bore, side, top");
    solid::HexMesh mixed = mesh;
    mixed.facet_sets["skin"] = mesh.facet_sets.at("side");
    mixed.facet_sets["skin"].push_back(mesh.facet_sets.at("top").front());
    CHECK(slice_of(mixed, locator, "skin", Vector3d::UnitY(), 0.001)
              .problems()
              .at(0)
              .what.starts_with("side 'skin' lies across the axis at element"));
    CHECK(slice_of(mesh, locator, "side", Vector3d::UnitY(), 0.012).problems().at(0).what.find("the part ends") !=
          std::string::npos);
}

TEST_CASE("a slice beneath an end lies straight below it, with two directions across the axis") {
    const solid::HexMesh mesh = tube();
    const solid::Locator locator(mesh);
    const auto top = slice_of(mesh, locator, "top", Vector3d::UnitY(), 0.002);
    REQUIRE_MESSAGE(top, to_string(top.problems()));
    CHECK(top->points.size() == 12 * 6); // five rings of hexahedra
    CHECK(top->beneath_end(Vector3d::UnitY()));
    double area = 0;
    for (const SlicePoint& point : top->points) {
        CHECK(point.place.y() == about(0.098, 1e-12));
        CHECK((point.directions.normal - Vector3d::UnitY()).norm() < 1e-12);
        CHECK((point.directions.contour - Vector3d::UnitX()).norm() < 1e-12);
        CHECK((point.directions.along + Vector3d::UnitZ()).norm() < 1e-12);
        area += point.area;
    }
    // Twelve-sided, outside and in: 12 / 2 sin(30 degrees) (R^2 - r^2).
    CHECK(area == about(3 * (0.015 * 0.015 - 0.005 * 0.005), 1e-9));
    // A column under its own 100 kPa: that is what presses on the slice, and nothing shears.
    const auto parts = components_on(*top, mesh, stresses(mesh, [](const Vector3d&) {
        Stress stress = Stress::Zero();
        stress[1] = -1e5;
        return stress;
    }));
    CHECK((parts.row(0).array() + 1e5).abs().maxCoeff() < 1e-6);
    CHECK(parts.bottomRows<2>().cwiseAbs().maxCoeff() < 1e-6);
    const auto base = slice_of(mesh, locator, "base", Vector3d::UnitY(), 0.002);
    REQUIRE(base);
    CHECK((base->points[0].directions.contour + Vector3d::UnitX()).norm() < 1e-12); // from below, x lies to the left
}

TEST_CASE("figures of a slice without a point that counts are not numbers") {
    const solid::HexMesh mesh = tube();
    const auto top = slice_of(mesh, solid::Locator(mesh), "top", Vector3d::UnitY(), 0.002).value();
    const auto points = static_cast<Eigen::Index>(top.points.size());
    const SliceFigures none = figures_of(top, Eigen::Matrix3Xd::Constant(3, points, -1e5), {.lower = 0.5});
    for (const double figure :
         {none.normal, none.contour, none.along, none.compression, none.tension, none.mean_compression,
          none.mean_tension, none.compressed_area, none.near_edges, none.elsewhere, none.compressive_share()})
        CHECK(std::isnan(figure));
    CHECK(none.compressed == 0);
    CHECK(figures_of(top, Eigen::Matrix3Xd::Constant(3, points, -1e5), {}).normal == -1e5);
}

TEST_CASE("a linear stress field is found exactly at the slice's points, in its three directions") {
    // Hydrostatic pressure that rises with depth below y = 0.2, and a shear yz of 300 Pa.
    const solid::HexMesh mesh = tube();
    const auto slice = slice_of(mesh, solid::Locator(mesh), "side", Vector3d::UnitY(), 0.0005).value();
    const auto parts = components_on(slice, mesh, stresses(mesh, [](const Vector3d& at) {
                                         Stress stress = Stress::Zero();
                                         stress.head<3>().setConstant(-1e4 * (0.2 - at.y()));
                                         stress[4] = 300;
                                         return stress;
                                     }));
    for (std::size_t p = 0; p < slice.points.size(); ++p) {
        const auto part = parts.col(static_cast<Eigen::Index>(p));
        CHECK(part[0] == about(-1e4 * (0.2 - slice.points[p].place.y()), 1e-9));
        CHECK(std::abs(part[1]) < 1e-9);
        CHECK(std::abs(part[2] - 300 * slice.points[p].directions.normal.z()) < 1e-7);
    }
}

TEST_CASE("points know how far their side's end is and how high they are, and figures heed both") {
    // A bar of 20 x 20 x 100 mm with bricks of 5 mm: its sides end at their four lines.
    const solid::HexMesh mesh = *solid::mesh_of(
        solid::Prism{.length = 0.1, .side = 0.02, .corner = 0.005, .corner_cells = 1, .middle_cells = 2, .along = 20},
        {});
    const auto slice = slice_of(mesh, solid::Locator(mesh), "+x", Vector3d::UnitY(), 0.001).value();
    REQUIRE(slice.points.size() == 5 * 21);
    Eigen::Matrix3Xd parts = Eigen::Matrix3Xd::Zero(3, 5 * 21);
    for (std::size_t p = 0; p < slice.points.size(); ++p) {
        const Vector3d& node = mesh.nodes[static_cast<std::size_t>(slice.points[p].node)];
        CHECK(std::abs(slice.points[p].edge - std::min({0.01 - std::abs(node.z()), node.y(), 0.1 - node.y()})) < 1e-15);
        CHECK(slice.points[p].height == about(node.y() / 0.1, 1e-12));
        parts(0, static_cast<Eigen::Index>(p)) =
            (slice.points[p].edge < 0.004 ? -300.0 : -100.0) + (node.y() > 0.06 ? 1e6 : 0.0);
    }
    // Of the lower half, with 3 mm of edge: its two upright lines and its lower end, at 300 Pa.
    const SliceFigures half = figures_of(slice, parts, {.lower = 0.5, .edge = 0.003});
    CHECK(half.near_edges == about(300));
    CHECK(half.elsewhere == about(100));
    CHECK(half.normal == -300);
    // With all that is within 7 mm there are, in the same half, points of both kinds: a column of nodes 5 mm wide, half
    // of it at the line itself, has 2.5 and 5 mm, of the 20 mm; a row of the same 2.5 and 5 of 52.5 mm.
    const SliceFigures wide = figures_of(slice, parts, {.lower = 0.5, .edge = 0.007});
    const double lines = 20 * 52.5 - 15 * 50, near = 20 * 52.5 - 5 * 45; // mm2, of 300 Pa, and of those within 7 mm
    CHECK(wide.near_edges == about((300 * lines + 100 * (near - lines)) / near));
    CHECK(figures_of(slice, parts, {}).normal > 9e5);
    CHECK(std::isnan(figures_of(slice, parts, {.edge = 1}).elsewhere));
}

TEST_CASE("the figures are those of the thesis' tables 7.3 to 7.5") {
    Slice slice{"side", 0.001, std::vector<SlicePoint>(5)};
    slice.points[4].area = 3;
    for (int p = 0; p < 4; ++p)
        slice.points[static_cast<std::size_t>(p)].area = 1;
    Eigen::Matrix3Xd parts(3, 5);
    parts << -2000, 1000, -400, 600, -4000, 10, -20, 30, -40, 5, 1, 2, -3, 2, 1;
    const SliceFigures figures = figures_of(slice, parts, {.trivial = 500});
    CHECK(figures.normal == -4000);
    CHECK(figures.worst_point == 4);
    CHECK(figures.contour == 40);
    CHECK(figures.along == 3);
    CHECK(figures.compression == -4000);
    CHECK(figures.tension == 1000);
    CHECK(figures.mean_compression == -3000); // -400 is trivial
    CHECK(figures.mean_tension == 800);
    CHECK(figures.compressed == 2);
    CHECK(figures.stretched == 2);
    CHECK(figures.compressed_area == about(4.0 / 7));
    CHECK(figures.stretched_area == about(2.0 / 7));
    // The thesis' own first row: means of 18866 and 6381 Pa are 74.7 and 25.3 %.
    SliceFigures row;
    row.mean_compression = -18866;
    row.mean_tension = 6381;
    CHECK(100 * row.compressive_share() == about(74.7, 1e-3));
}

TEST_CASE("a load case is a VTU file with all hexahedra and nodes") {
    const solid::HexMesh mesh = tube();
    const auto nodes = static_cast<Eigen::Index>(mesh.nodes.size());
    const Eigen::VectorXd rows = Eigen::VectorXd::Zero(3 * nodes);
    const std::string text = part_vtu(mesh, rows, rows, Eigen::VectorXd::Zero(6 * nodes), 0.25);
    CHECK(text.find("<VTKFile type=\"UnstructuredGrid\"") != std::string::npos);
    CHECK(text.find("<Piece NumberOfPoints=\"360\" NumberOfCells=\"240\">") != std::string::npos);
    for (const char* name : {"displacement_m", "load_N", "stress_Pa", "von_mises_Pa", "types", "element", "node"})
        CHECK(text.find(std::string("Name=\"") + name + "\"") != std::string::npos);
}

} // namespace test_slice
