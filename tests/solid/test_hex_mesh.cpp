#include "about.h"
#include "solid/generate.h"
#include "solid/hex_mesh.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <numbers>

namespace test_hex_mesh {

using namespace tumble;
using namespace tumble::solid;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

/// The thesis' specimens (figures 7.16 and 7.32).
BoredCylinder thesis_cylinder() {
    return {.length = 0.1,
            .radius = 0.015,
            .bore_radius = 0.005,
            .shell = 0.0015,
            .around = 60,
            .along = 12,
            .shell_rings = 3,
            .inner_rings = 6};
}
Prism thesis_prism() {
    return {.length = 0.1, .side = 0.015, .corner = 0.0048, .corner_cells = 6, .middle_cells = 10, .along = 60};
}

HexMesh cube() {
    HexMesh mesh;
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
            mesh.nodes.emplace_back(x, y, z);
    mesh.hexes = {{0, 1, 2, 3, 4, 5, 6, 7}};
    return mesh;
}

} // namespace

TEST_CASE("the cylinder has the thesis' hexahedra; its 13 further nodes belong to none") {
    const auto mesh = mesh_of(thesis_cylinder(), {});
    REQUIRE(mesh);
    CHECK(mesh->hexes.size() == 6480);
    const auto in_shell = std::count_if(mesh->hexes.begin(), mesh->hexes.end(), [&](const auto& hex) {
        Vector3d middle = Vector3d::Zero();
        for (const int node : hex)
            middle += mesh->nodes[static_cast<std::size_t>(node)] / 8;
        return Vector3d(middle.x(), 0, middle.z()).norm() > 0.0134; // facets lie inside their circle
    });
    CHECK(in_shell == 2160);
    CHECK(mesh->nodes.size() == 7813 - 13);
}

TEST_CASE("the prism has the thesis' hexahedra, 8640 in the corners, and one node more than it prints") {
    const Prism prism = thesis_prism();
    const auto mesh = mesh_of(prism, {});
    REQUIRE(mesh);
    CHECK(mesh->hexes.size() == 29040);
    CHECK(mesh->nodes.size() == 32268 + 1);
    int corner = 0, lateral = 0, core = 0;
    for (int hex = 0; hex < 29040; ++hex) {
        const Vector3d middle = mesh->corners_of(hex).rowwise().mean();
        const double limit = prism.side / 2 - prism.corner;
        const int outside = (std::abs(middle.x()) > limit ? 1 : 0) + (std::abs(middle.z()) > limit ? 1 : 0);
        ++(outside == 2 ? corner : outside == 1 ? lateral : core);
    }
    CHECK(corner == 8640);
    CHECK(lateral == 14400);
    CHECK(core == 6000);
}

TEST_CASE("a bored polygon has the volume that its corners say, and its facets close it") {
    // n triangles of sides r and angle 2 pi / n between them: area n/2 sin(2 pi / n) r^2.
    const Place leaning{{0.1, 0.02, -0.03}, Vector3d(0.5, std::sqrt(0.75), 0)};
    const BoredCylinder part = thesis_cylinder();
    const auto mesh = mesh_of(part, leaning);
    REQUIRE(mesh);
    const double area =
        30 * std::sin(2 * std::numbers::pi / 60) * (part.radius * part.radius - part.bore_radius * part.bore_radius);
    CHECK(volume_of(*mesh) == about(area * part.length, 1e-12));
    // Gauss: the outward area vectors add up to 0, and a third of their product with the place is the volume.
    Vector3d sum = Vector3d::Zero();
    double volume = 0;
    for (int f = 0; f < static_cast<int>(mesh->facets.size()); ++f) {
        sum += mesh->area_of(f);
        volume += mesh->area_of(f).dot(mesh->centre_of(f)) / 3;
    }
    CHECK(sum.norm() < 1e-15);
    CHECK(volume == about(area * part.length, 1e-9));
    CHECK(mesh->facet_sets.at("side").size() == 60 * 12);
    CHECK(mesh->facet_sets.at("bore").size() == 60 * 12);
    CHECK(mesh->facet_sets.at("top").size() == 60 * 9);
    CHECK(mesh->node_sets.at("base").size() == 600);
    for (const int node : mesh->node_sets.at("base"))
        CHECK(std::abs(leaning.axis.dot(mesh->nodes[static_cast<std::size_t>(node)] - leaning.base)) < 1e-12);
}

TEST_CASE("the shell's nodes lie at the depths of the thesis' slices") {
    const auto mesh = mesh_of(thesis_cylinder(), {});
    REQUIRE(mesh);
    for (const double depth : {0.0005, 0.001, 0.0015})
        CHECK(std::count_if(mesh->nodes.begin(), mesh->nodes.end(), [&](const Vector3d& node) {
                  return std::abs(std::hypot(node.x(), node.z()) - (0.015 - depth)) < 1e-12;
              }) == 60 * 13);
}

TEST_CASE("triangles 2f and 2f + 1 are facet f") {
    const auto mesh = mesh_of(thesis_prism(), {});
    REQUIRE(mesh);
    const auto triangles = triangles_of(*mesh);
    REQUIRE(triangles.size() == 2 * mesh->facets.size());
    for (std::size_t f = 0; f < mesh->facets.size(); f += 101) {
        Vector3d area = Vector3d::Zero();
        for (const std::size_t t : {2 * f, 2 * f + 1})
            area += 0.5 * (triangles[t][1] - triangles[t][0]).cross(triangles[t][2] - triangles[t][0]);
        CHECK((area - mesh->area_of(static_cast<int>(f))).norm() < 1e-18);
    }
}

TEST_CASE("bad elements and loose nodes are named by their numbers") {
    HexMesh mesh = cube();
    mesh.nodes.emplace_back(5, 5, 5);
    mesh.node_numbers = {11, 12, 13, 14, 15, 16, 17, 18, 99};
    mesh.hex_numbers = {70};
    std::swap(mesh.hexes[0][0], mesh.hexes[0][4]); // two corners cross: folded
    const auto folded = finished(mesh);
    REQUIRE_FALSE(folded);
    REQUIRE(folded.problems().size() == 2);
    CHECK(folded.problems()[0].what == "1 node belongs to no hexahedron: 99");
    CHECK(folded.problems()[1].what.starts_with("element 70 is inside out or folded: its Jacobian determinant is -"));

    HexMesh twice = cube();
    twice.hexes[0][7] = twice.hexes[0][6];
    const auto repeated = finished(twice);
    REQUIRE_FALSE(repeated);
    CHECK(repeated.problems().back().what == "element 1 has a node twice");

    HexMesh triple = cube();
    triple.hexes = {triple.hexes[0], triple.hexes[0], triple.hexes[0]};
    const auto shared = finished(triple);
    REQUIRE_FALSE(shared);
    CHECK(shared.problems()[0].what == "more than two hexahedra share a face of element 3");
    CHECK_FALSE(finished(HexMesh{}));
}

TEST_CASE("a mesh in pieces, or with a crack, is refused with the numbers of elements and nodes") {
    // Two cubes side by side at x = 1; the second has its own nodes, then all but the shared face's, then an edge's.
    HexMesh cracked = cube();
    const HexMesh one = cube();
    for (const Vector3d& node : one.nodes)
        cracked.nodes.emplace_back(node + Vector3d(1, 0, 0));
    cracked.hexes.push_back({8, 9, 10, 11, 12, 13, 14, 15});
    const auto crack = finished(cracked);
    REQUIRE_FALSE(crack);
    CHECK(crack.problems()[0].what ==
          "nodes lie in the same place, where the part is cracked: 2 and 9, 3 and 12, 6 and 13, 7 and 16");

    HexMesh apart = cracked;
    for (std::size_t node = 8; node < 16; ++node)
        apart.nodes[node].x() += 0.5;
    apart.hex_numbers = {5, 17};
    const auto pieces = finished(apart);
    REQUIRE_FALSE(pieces);
    CHECK(pieces.problems()[0].what == "the part is in pieces: element 17 hangs by no face on element 5");

    HexMesh hinge = cube(); // the edge from node 2 to node 6 is all that they share
    for (const auto& [x, y] : {std::pair{2.0, 0.0}, {2.0, -1.0}, {1.0, -1.0}})
        for (const double z : {0.0, 1.0})
            hinge.nodes.emplace_back(x, y, z);
    hinge.hexes.push_back({12, 10, 8, 1, 13, 11, 9, 5});
    const auto by_an_edge = finished(hinge);
    REQUIRE_FALSE(by_an_edge);
    CHECK(by_an_edge.problems()[0].what == "the part is in pieces: element 2 hangs by no face on element 1");

    HexMesh joined = cube();
    for (const auto& [y, z] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}})
        joined.nodes.emplace_back(2, y, z);
    joined.hexes.push_back({1, 8, 9, 2, 5, 10, 11, 6});
    const auto whole = finished(joined);
    REQUIRE_MESSAGE(whole, to_string(whole.problems()));
    CHECK(whole->facets.size() == 10);
}

TEST_CASE("coordinates whose Jacobian is no number are refused, in whichever order its points come") {
    HexMesh huge = cube();
    for (Vector3d& node : huge.nodes)
        node *= 1e150;
    const auto refused = finished(huge);
    REQUIRE_FALSE(refused);
    CHECK(refused.problems()[0].what.starts_with("element 1 is inside out or folded"));
}

TEST_CASE("more hexahedra than numbers can count are refused at their key before one is made") {
    BoredCylinder tube = thesis_cylinder();
    tube.around = 1000;
    tube.along = 10000;
    tube.inner_rings = tube.shell_rings = 1000;
    CHECK(mesh_of(tube, {}).problems().at(0).what ==
          "10000 layers of 2000000 hexahedra are more than the 2000000 that a part may have");
    Prism fine = thesis_prism();
    fine.corner_cells = fine.middle_cells = 1000;
    fine.along = 10000;
    CHECK(mesh_of(fine, {}).problems().at(0).key == "along");
}

TEST_CASE("sizes that leave nothing are refused at their key") {
    BoredCylinder hollow = thesis_cylinder();
    hollow.bore_radius = 0.015;
    CHECK(mesh_of(hollow, {}).problems().at(0).key == "bore_radius_m");
    BoredCylinder thick = thesis_cylinder();
    thick.shell = 0.01;
    CHECK(mesh_of(thick, {}).problems().at(0).key == "shell_m");
    Prism cut = thesis_prism();
    cut.corner = 0.0075;
    CHECK(mesh_of(cut, {}).problems().at(0).key == "corner_m");
    Prism flat = thesis_prism();
    flat.along = 0;
    CHECK(mesh_of(flat, {}).problems().at(0).key == "along");
}

} // namespace test_hex_mesh
