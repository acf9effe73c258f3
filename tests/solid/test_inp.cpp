#include "base/text.h"
#include "folder.h"
#include "solid/generate.h"
#include "solid/inp.h"

#include <doctest/doctest.h>

namespace test_inp {

using namespace tumble;
using namespace tumble::solid;
using Eigen::Vector3d;

namespace {

const std::string cube =
    "** a comment\n*HEADING\nwhatever stands here\n*Node, NSET=Nall\n 1, 0,0,0\n2, 1,0,0\n3, 1,1,0\n"
    "4, 0,1,0\n5, 0,0,1\n6, 1,0,1\n7, 1,1,1\n8, 0,1,1\n*ELEMENT, TYPE=CPS4, ELSET=Surface1\n1, 1,2,3,4\n*ELEMENT, "
    "TYPE=C3D8, ELSET=Volume1\n"
    "69, 1,2,3,4,\n5,6,7,8\n*NSET, NSET=Boundary\n4, 1,\n2\n*NSET, NSET=upper, GENERATE\n5, 8, 1\n"
    "*NSET, NSET=both\nBOUNDARY, upper\n*MATERIAL, NAME=Steel\n*ELASTIC\n20+11, 0.3\n";

std::string problem(const std::string& text) {
    const auto mesh = parse_inp(text, "part.inp");
    return mesh ? "none" : to_string(mesh.problems()[0]);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("a mesh as the thesis writes it is read: nodes, an element over two lines, sets") {
    const auto mesh = parse_inp(cube, "part.inp", 1e-3);
    REQUIRE_MESSAGE(mesh, to_string(mesh.problems()));
    CHECK(mesh->nodes.size() == 8);
    CHECK(mesh->nodes[6] == Vector3d(1e-3, 1e-3, 1e-3));
    CHECK(mesh->hex_numbers == std::vector{69});
    CHECK(mesh->facets.size() == 6);
    CHECK(mesh->node_sets.at("BOUNDARY") == std::vector{0, 1, 3});
    CHECK(mesh->node_sets.at("UPPER") == std::vector{4, 5, 6, 7});
    CHECK(mesh->node_sets.at("BOTH") == std::vector{0, 1, 3, 4, 5, 6, 7});
    CHECK(mesh->node_sets.at("NALL").size() == 8);
}

TEST_CASE("what is wrong with a file is said at its line") {
    CHECK(problem(changed(cube, "2, 1,0,0", "2, 1,zero,0")).starts_with("part.inp:6: 'zero' is no coordinate"));
    CHECK(problem(changed(cube, "2, 1,0,0", "2, 1,0")).starts_with("part.inp:6: a node needs its number and three"));
    CHECK(problem(changed(cube, "2, 1,0,0", "1, 1,0,0")).starts_with("part.inp:6: node 1 is there twice"));
    CHECK(problem(changed(cube, "5,6,7,8", "5,6,7,9")).starts_with("part.inp:16: element 69 names node 9, which is"));
    CHECK(problem(changed(cube, "5,6,7,8", "5,6,7")).starts_with("part.inp:16: element 69 ends after 7 of its 8"));
    CHECK(problem(changed(cube, "5,6,7,8", "5,6,7,8,1")).starts_with("part.inp:16: element 69 has 9 nodes instead"));
    CHECK(problem(changed(cube, "C3D8", "C3D20")).starts_with("part.inp:15: elements of type 'C3D20' are not read"));
    CHECK(
        problem(changed(cube, "4, 1,\n", "4, 1, x\n")).starts_with("part.inp:19: set BOUNDARY names set X, which is"));
    CHECK(problem(changed(cube, "5, 8, 1", "8, 5, 1")).starts_with("part.inp:22: GENERATE needs a first and a last"));
    CHECK(problem(changed(cube, "69, 1,2,3,4", "69, 4,3,2,1")).find("element 69 is inside out") != std::string::npos);
    CHECK(problem(changed(cube, "*ELEMENT, TYPE=C3D8", "*ELEMNT, TYPE=C3D8"))
              .starts_with("part.inp:2: no hexahedra come of it; passed over: *HEADING in line 2, *ELEMNT in line 15, "
                           "*MATERIAL in line 25, *ELASTIC in line 26"));
    CHECK(problem("1, 2, 3\n").starts_with("part.inp:1: data before the first keyword"));
    CHECK(problem("").starts_with("part.inp: the mesh has no hexahedra"));
}

TEST_CASE("a range of nodes that are not there ends after the first ones, whatever its last number") {
    const auto mesh = parse_inp(changed(cube, "5, 8, 1", "5, 2000000000"), "part.inp");
    REQUIRE_FALSE(mesh);
    CHECK(to_string(mesh.problems()[0]).starts_with("part.inp:22: set UPPER names node 9, which is not there"));
    CHECK(mesh.problems().size() <= 20);
}

TEST_CASE("a set may name sets that are filled further down, and itself") {
    const std::string nested = "*NSET, NSET=all\nmiddle, all\n*NSET, NSET=middle\nlast\n*NSET, NSET=last\n7\n";
    const auto mesh = parse_inp(cube + nested, "part.inp");
    REQUIRE_MESSAGE(mesh, to_string(mesh.problems()));
    CHECK(mesh->node_sets.at("ALL") == std::vector{6});
}

TEST_CASE("keywords that make, move or fetch nodes are refused at their line") {
    CHECK(problem("*INSTANCE, NAME=a, PART=b\n" + cube).starts_with("part.inp:1: *INSTANCE makes or moves nodes"));
    CHECK(problem("*SYSTEM\n0, 0, 1\n" + cube).starts_with("part.inp:1: *SYSTEM makes or moves nodes"));
    CHECK(problem(cube + "*ELGEN\n69, 4\n").find("*ELGEN makes or moves nodes") != std::string::npos);
    CHECK(problem("*NODE, INPUT=nodes.inp\n" + cube).starts_with("part.inp:1: *NODE of another file is not followed"));
    CHECK(problem("*INCLUDE, INPUT=mesh.inp\n").starts_with("part.inp:1: *INCLUDE of another file is not followed"));
}

TEST_CASE("a part of a file has its surface by the axis, and the set that is held by name") {
    const test::Folder folder;
    test::put(folder.path / "cube.inp", cube);
    const auto mesh = mesh_of(MeshFile{folder.path / "cube.inp", 2}, {Vector3d::Zero(), Vector3d::UnitZ()});
    REQUIRE_MESSAGE(mesh, to_string(mesh.problems()));
    CHECK(mesh->facet_sets.at("side").size() == 4);
    CHECK(mesh->centre_of(mesh->facet_sets.at("top").at(0)) == Vector3d(1, 1, 2));
    CHECK(mesh_of(MeshFile{folder.path / "none.inp", 1}, {}).problems().at(0).what == "cannot be read");
    test::put(folder.path / "empty.inp", "");
    CHECK(mesh_of(MeshFile{folder.path / "empty.inp", 1}, {}).problems().at(0).what == "is empty");
    test::put(folder.path / "cube.MSH", "$MeshFormat\n9 0 8\n");
    CHECK(mesh_of(MeshFile{folder.path / "cube.MSH", 1}, {}).problems().at(0).what.find("*NODE") == std::string::npos);
}

TEST_CASE("what is written reads back, and no number is longer than the 20 letters that CalculiX reads") {
    const BoredCylinder part{.length = 0.1,
                             .radius = 0.015,
                             .bore_radius = 0.005,
                             .shell = 0.0015,
                             .around = 7,
                             .along = 2,
                             .shell_rings = 1,
                             .inner_rings = 1};
    const HexMesh mesh = *mesh_of(part, {});
    Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(mesh.nodes.size()));
    force(1, 5) = -0.1;
    const std::string text = to_inp(mesh, {2e11, 0.3, "C3D8", {"base"}}, {{"first", force}});
    const auto again = parse_inp(text, "again.inp");
    REQUIRE_MESSAGE(again, to_string(again.problems()));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        CHECK((again->nodes[n] - mesh.nodes[n]).norm() <= 1e-13 * mesh.nodes[n].norm());
    for (const std::string_view line : split(text, '\n'))
        for (const std::string_view word : split(line, ','))
            if (!line.starts_with('*'))
                CHECK(trimmed(word).size() <= 20);
    CHECK(text.starts_with("** units: m, N, Pa; 28 C3D8 elements of 63 nodes\n*NODE"));
    CHECK(to_inp(mesh, {2e11, 0.3, "C3D8", {}, false, {"a title\nin two lines", "by whom"}}, {})
              .starts_with("** a title in two lines\n** by whom\n** units: m, N, Pa"));
    CHECK(again->hexes == mesh.hexes);
    CHECK(again->node_sets.at("BASE") == mesh.node_sets.at("base"));
    CHECK(again->node_sets.at("TOP") == mesh.node_sets.at("top"));
    CHECK(text.find("*CLOAD, OP=NEW\n6, 2, -0.1\n") != std::string::npos);
    CHECK(text.find("*BOUNDARY\nbase, 1, 3\n") != std::string::npos);
    CHECK(again->node_sets.at("ALL").size() == mesh.nodes.size());

    HexMesh some = mesh; // a file's own "ALL", of two nodes
    some.node_sets["ALL"] = {3, 5};
    const auto kept = parse_inp(to_inp(some, {2e11, 0.3, "C3D8", {"ALL"}}, {}), "kept.inp");
    REQUIRE_MESSAGE(kept, to_string(kept.problems()));
    CHECK(kept->node_sets.at("ALL") == std::vector{3, 5});
    CHECK(kept->node_sets.at("ALL_").size() == mesh.nodes.size());
}

} // namespace test_inp
