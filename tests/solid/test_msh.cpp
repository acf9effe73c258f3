#include "base/text.h"
#include "folder.h"
#include "solid/inp.h"
#include "solid/msh.h"

#include <doctest/doctest.h>

namespace test_msh {

using namespace tumble;
using namespace tumble::solid;
using Eigen::Vector3d;

namespace {

/// Two cubes above each other along z; the lower one's floor is "held", the corner at the origin "corner", both cubes
/// "part", and the upper cube is in group 9 without a name, too.
const std::string in_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n0 1 \"corner\"\n2 2 \"held\"\n"
                         "3 3 \"part\"\n$EndPhysicalNames\n$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n"
                         "6 1 0 1\n7 1 1 1\n8 0 1 1\n11 0 0 2\n12 1 0 2\n13 1 1 2\n14 0 1 2\n$EndNodes\n$Elements\n5\n"
                         "1 15 2 1 1 1\n2 3 2 2 1 1 2 3 4\n3 5 2 3 1 1 2 3 4 5 6 7 8\n4 5 2 3 1 5 6 7 8 11 12 13 14\n"
                         "5 5 2 9 1 5 6 7 8 11 12 13 14\n$EndElements\n";

const std::string in_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n0 1 \"corner\"\n2 2 \"held\"\n3 3 \"part\"\n"
    "$EndPhysicalNames\n$Entities\n1 0 1 2\n1 0 0 0 1 1\n1 0 0 0 1 1 0 1 2 0\n1 0 0 0 1 1 1 1 3 1 1\n"
    "2 0 0 1 1 1 2 2 3 9 0\n$EndEntities\n$Nodes\n3 12 1 14\n0 1 0 1\n1\n0 0 0\n2 1 0 3\n2\n3\n4\n1 0 0\n1 1 0\n0 1 0\n"
    "3 1 0 8\n5\n6\n7\n8\n11\n12\n13\n14\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n0 0 2\n1 0 2\n1 1 2\n0 1 2\n$EndNodes\n"
    "$Elements\n4 4 1 4\n0 1 15 1\n1 1\n2 1 3 1\n2 1 2 3 4\n3 1 5 1\n3 1 2 3 4 5 6 7 8\n3 2 5 1\n"
    "4 5 6 7 8 11 12 13 14\n$EndElements\n$NodeData\n1\n\"a view\"\n$EndNodeData\n";

std::string problem(const std::string& text) {
    const auto mesh = parse_msh(text, "part.msh");
    return mesh ? "none" : to_string(mesh.problems()[0]);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("both formats of gmsh are read: nodes, hexahedra with their numbers, physical groups as sets") {
    for (const std::string& text : {in_2, in_4}) {
        CAPTURE(text);
        const auto mesh = parse_msh(text, "part.msh", 1e-3);
        REQUIRE_MESSAGE(mesh, to_string(mesh.problems()));
        CHECK(mesh->nodes.size() == 12);
        CHECK(mesh->nodes[6] == Vector3d(1e-3, 1e-3, 1e-3));
        CHECK(mesh->hex_numbers == std::vector{3, 4});
        CHECK(mesh->facets.size() == 10); // of 12, two meet
        CHECK(mesh->node_sets.at("corner") == std::vector{0});
        CHECK(mesh->node_sets.at("held") == std::vector{0, 1, 2, 3});
        CHECK(mesh->node_sets.at("part").size() == 12);
        CHECK(mesh->node_sets.at("9") == std::vector{4, 5, 6, 7, 8, 9, 10, 11});
        CHECK(mesh->node_sets.size() == 4);
    }
}

TEST_CASE("what gmsh and CalculiX say of one mesh is the same mesh") {
    const auto mesh = parse_msh(in_4, "part.msh");
    REQUIRE(mesh);
    const auto again = parse_inp(to_inp(*mesh, {2e11, 0.3, "C3D8", {"held"}}, {}), "part.inp");
    REQUIRE_MESSAGE(again, to_string(again.problems()));
    CHECK(again->hexes == mesh->hexes);
    CHECK(again->nodes == mesh->nodes);
    CHECK(again->node_sets.at("HELD") == mesh->node_sets.at("held"));
}

TEST_CASE("what is wrong with a file of gmsh is said at its line, with what to do") {
    CHECK(problem("") == "part.msh: the mesh has no hexahedra\n    a part needs at least one C3D8 element");
    CHECK(problem("*NODE\n1, 0, 0, 0\n").starts_with("part.msh:1: this is no file of gmsh\n    a .msh file begins"));
    CHECK(problem(changed(in_2, "2.2 0 8", "2.2 1 8")).starts_with("part.msh:2: the file is binary\n    save it as A"));
    CHECK(problem(changed(in_4, "4.1 0 8", "4 0 8")).starts_with("part.msh:2: format 4 is not read\n    save it as 4"));
    CHECK(problem(changed(in_2, "2 1 0 0", "2 1 nil 0")).starts_with("part.msh:13: 'nil' is no coordinate"));
    CHECK(problem(changed(in_2, "2 1 0 0", "2 1 0")).starts_with("part.msh:13: a line of $Nodes needs 4 values, here"));
    CHECK(problem(changed(in_2, "2 1 0 0", "1 1 0 0")).starts_with("part.msh:13: node 1 is there twice"));
    CHECK(problem(changed(in_2, "$Nodes\n12", "$Nodes\n13")).starts_with("part.msh:24: $Nodes ends too early"));
    CHECK(
        problem(changed(in_2, "$Nodes\n12", "$Nodes\n11")).starts_with("part.msh:23: $Nodes goes on where it should"));
    CHECK(problem(changed(in_2, "$Nodes\n12", "$Nodes\ntwo")).starts_with("part.msh:11: 'two' is no whole number"));
    CHECK(problem(changed(in_2, "3 5 2 3 1 1 2", "3 5 2 3 1 1 21"))
              .starts_with("part.msh:29: element 3 names node 21, which is not there\n    list it under $Nodes"));
    CHECK(problem(changed(in_2, "5 6 7 8\n4", "5 6 7\n4"))
              .starts_with("part.msh:29: element 3 has 7 nodes instead of 8"));
    CHECK(problem(changed(in_2, "4 5 2 3 1 5", "3 5 2 3 1 5")).starts_with("part.msh:30: element 3 is there twice"));
    CHECK(
        problem(changed(in_2, "3 5 2 3 1 1 2 3 4 5 6 7 8", "3 4 2 3 1 1 2 3 5"))
            .starts_with("part.msh:29: tetrahedra of 4 nodes (type 4) are not read\n    mesh the part with hexahedra"));
    CHECK(problem(changed(in_2, "1 2 3 4 5 6 7 8", "4 3 2 1 8 7 6 5")).find("element 3 is inside out") !=
          std::string::npos);
    CHECK(problem(changed(changed(in_2, "$Nodes\n12", "$Nodes\n13"), "14 0 1 2\n", "14 0 1 2\n15 3 3 3\n"))
              .find("1 node belongs to no hexahedron: 15") != std::string::npos);
    CHECK(problem(changed(in_2, "\"held\"", "held")).starts_with("part.msh:7: a physical group has no name in quotes"));
    CHECK(problem(changed(in_4, "$EndNodeData\n", "")).starts_with("part.msh:61: $NodeData never ends"));
    CHECK(problem(changed(in_4, "3 2 5 1\n", "3 2 17 1\n")).find(": hexahedra of 20 nodes (type 17) are not read") !=
          std::string::npos);
    CHECK(problem(changed(in_4, "1 0 0 0 1 1 1 1 3 1 1", "1 0 0 0 1 1 1 5 3"))
              .starts_with("part.msh:14: the line is too short"));
}

TEST_CASE("a part of gmsh has its surface by the axis") {
    const test::Folder folder;
    test::put(folder.path / "part.msh", in_4);
    const auto mesh = mesh_of(MeshFile{folder.path / "part.msh", 2}, {Vector3d::Zero(), Vector3d::UnitZ()});
    REQUIRE_MESSAGE(mesh, to_string(mesh.problems()));
    CHECK(mesh->facet_sets.at("side").size() == 8);
    CHECK(mesh->centre_of(mesh->facet_sets.at("top").at(0)) == Vector3d(1, 1, 4));
    CHECK(read_msh(folder.path / "none.msh").problems().at(0).what == "cannot be read");
}

} // namespace test_msh
