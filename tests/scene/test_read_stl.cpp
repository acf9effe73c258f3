#include "scene/read_stl.h"

#include <bit>
#include <cstdint>
#include <doctest/doctest.h>
#include <limits>
#include <string>

namespace test_read_stl {

using namespace tumble;
using namespace tumble::scene;

namespace {

void append(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(value >> shift & 0xff);
}

/// A binary STL file of triangles (0 0 0), (a 0 0), (0 a 0) for each a.
std::string binary(const std::vector<float>& sizes, std::string head = "solid made by us") {
    head.resize(80, '\0');
    append(head, static_cast<std::uint32_t>(sizes.size()));
    for (const float a : sizes) {
        for (const float value : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, a, 0.f, 0.f, 0.f, a, 0.f})
            append(head, std::bit_cast<std::uint32_t>(value));
        head += std::string(2, '\0');
    }
    return head;
}

std::string ascii(const std::string& third_vertex) {
    return "solid lid\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 0.5 0 0\n  vertex " + third_vertex +
           "\n endloop\nendfacet\nendsolid lid\n";
}

std::string refusal(const std::string& bytes) {
    const Problems problems = parse_stl(bytes, "lid.stl").problems();
    return problems.empty()
               ? ""
               : to_string(Problem{problems[0].file, problems[0].line, problems[0].column, "", problems[0].what, ""});
}

} // namespace

TEST_CASE("ASCII and binary files of one surface give the same triangle") {
    const auto text = parse_stl(ascii("0 0.5 0"), "lid.stl");
    const auto bytes = parse_stl(binary({0.5f}), "lid.stl");
    REQUIRE(text);
    REQUIRE(bytes);
    REQUIRE(text->size() == 1);
    CHECK(*text == *bytes);
}

TEST_CASE("a binary file that begins with the word solid is known by its length") {
    const auto bytes = parse_stl(binary({1.f, 2.f, 3.f}, "solid facet normal"), "lid.stl");
    REQUIRE(bytes);
    CHECK(bytes->size() == 3);
    CHECK((*bytes)[2][1] == Eigen::Vector3d(3, 0, 0));
}

TEST_CASE("ASCII files may have several solids, capitals, tabs and lines that end in CR LF") {
    std::string text =
        "SOLID A\r\nFACET NORMAL 0 0 1\r\n\tOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 1E0 0 0\r\nVERTEX 0 +1 0"
        "\r\nENDLOOP\r\nENDFACET\r\nENDSOLID A\r\n";
    const auto mesh = parse_stl(text + text, "lid.stl");
    REQUIRE_MESSAGE(mesh, to_string(mesh.problems()));
    CHECK(mesh->size() == 2);
}

TEST_CASE("a broken file says where it breaks") {
    CHECK(refusal("") == "lid.stl:1: the file ends where 'solid' was expected");
    CHECK(refusal("solid\n") == "lid.stl: there is no triangle in this file");
    CHECK(refusal("hello\n") == "lid.stl:1:1: 'hello' where 'solid' was expected");
    CHECK(refusal(ascii("0 inf 0")) == "lid.stl:6:12: 'inf' is not a usable number");
    CHECK(refusal(ascii("0 1e300 0")) == "lid.stl:6:12: '1e300' is not a usable number");
    CHECK(refusal(ascii("0 1")) == "lid.stl:6:3: 'vertex' has 3 words where it needs 4");
    CHECK(refusal(ascii("0.25 0 0")) == "lid.stl:2: triangle 1 has no area");
    CHECK(refusal("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n") ==
          "lid.stl:4: the file ends where 'vertex' was expected");
    CHECK(refusal("solid\nfacet normal 0 0 1\nvertex 0 0 0\n") == "lid.stl:3:1: 'vertex' where 'outer' was expected");
    CHECK(refusal("solid\n\nfaced normal 0 0 1\n") == "lid.stl:3:1: 'faced' where 'facet' was expected");
}

TEST_CASE("a broken binary file says which triangle or how many bytes") {
    CHECK(refusal(binary({1.f, 2.f}).substr(0, 150)) ==
          "lid.stl: a binary STL file of 2 triangles has 184 bytes, this one has 150");
    CHECK(refusal(binary({1.f}) + "x") == "lid.stl: a binary STL file of 1 triangles has 134 bytes, this one has 135");
    CHECK(refusal(std::string("solid\0\0\0", 8)) == "lid.stl: 8 bytes are too few for a binary STL file");
    CHECK(refusal(binary({1.f, std::numeric_limits<float>::quiet_NaN()})) ==
          "lid.stl: triangle 2 has a corner that is not a usable number");
    CHECK(refusal(binary({1.f, 2.f, 0.f})) == "lid.stl: triangle 3 has no area");
    CHECK(refusal(binary({})) == "lid.stl: there is no triangle in this file");
    // A count that would overflow 32 bits when multiplied by 50.
    std::string lying = binary({1.f});
    lying.replace(80, 4, "\xff\xff\xff\xff");
    CHECK(refusal(lying) ==
          "lid.stl: a binary STL file of 4294967295 triangles has 214748364834 bytes, this one has 134");
}

TEST_CASE("a triangle a thousand times longer than wide is thin, not degenerate") {
    CHECK(parse_stl(ascii("0.5 0.0005 0"), "lid.stl"));
}

} // namespace test_read_stl
