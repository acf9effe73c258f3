#include "about.h"
#include "scene/read_clump.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <string>

namespace test_read_clump {

using namespace tumble;
using namespace tumble::scene;
using tumble::test::about;

namespace {

std::string refusal(const std::string& text) {
    const Problems problems = parse_clump(text, "cone.csv").problems();
    return problems.empty()
               ? ""
               : to_string(Problem{problems[0].file, problems[0].line, problems[0].column, "", problems[0].what, ""});
}

} // namespace

TEST_CASE("CSV and LIGGGHTS lines give the same spheres") {
    const auto csv = parse_clump("# a snowman\nx,y,z,radius\n0,0,0,0.01\n 0 , 0.015, 0 ,0.006 # head\n", "a.csv");
    const auto lines = parse_clump("# a snowman\r\n0 0 0 0.01\r\n\r\n\t0\t1.5e-2  0 6e-3\r\n", "a.txt");
    REQUIRE(csv);
    REQUIRE(lines);
    REQUIRE(csv->size() == 2);
    REQUIRE(lines->size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK((*csv)[i].centre == (*lines)[i].centre);
        CHECK((*csv)[i].radius == (*lines)[i].radius);
    }
    CHECK((*csv)[1].radius == 0.006);
}

TEST_CASE("the shipped cone is 22 mm high on a base of 19.4 mm") {
    // The sum of the highest centre and its radius; of the outer ring's radius and its spheres'.
    const auto cone = read_clump(TUMBLE_ROOT "/scenes/clumps/cone-65.csv");
    REQUIRE(cone);
    REQUIRE(cone->size() == 65);
    double top = 0;
    double reach = 0;
    double floor = 1;
    for (const Sphere& sphere : *cone) {
        top = std::max(top, sphere.centre.y() + sphere.radius);
        floor = std::min(floor, sphere.centre.y() - sphere.radius);
        reach = std::max(reach, std::hypot(sphere.centre.x(), sphere.centre.z()) + sphere.radius);
    }
    CHECK(top == about(0.0205 + 0.00155, 1e-12));
    CHECK(std::abs(floor) < 1e-12); // m
    CHECK(2 * reach == about(2 * (0.00815 + 0.00153), 1e-7));
}

TEST_CASE("a number that is cut off, a word and a missing column are found where they stand") {
    CHECK(refusal("x,y,z,radius\n0,0,0,0.01\n0,0,1e,0.01\n") == "cone.csv:3:5: '1e' is not a number");
    CHECK(refusal("0 0 0 0.01\n0 zero 0 0.01\n") == "cone.csv:2:3: 'zero' is not a number");
    CHECK(refusal("0 0 0\n") == "cone.csv:1:1: 3 values where a sphere has 4");
    CHECK(refusal("x,y,z,r\n0,0,0,1\n") == "cone.csv:1:1: 'x' is not a number");
    CHECK(refusal("0 0 0 nan\n") == "cone.csv:1:7: 'nan' is not a number");
    CHECK(refusal("0 0 0 0\n") == "cone.csv:1:7: the radius 0 is not above 0");
    CHECK(refusal("0 0 2500 1\n") == "cone.csv:1:5: 2500 m is too far for a body");
    CHECK(refusal("") == "cone.csv: there is no sphere in this file");
}

TEST_CASE("a file of nothing but mistakes does not list them all") {
    std::string text;
    for (int i = 0; i < 1000; ++i)
        text += "a b c d\n";
    const auto problems = parse_clump(text, "a.txt").problems();
    CHECK(problems.size() >= 20);
    CHECK(problems.size() < 30);
}

TEST_CASE("more spheres than a body may have are refused before they fill the memory") {
    std::string text;
    for (std::size_t i = 0; i <= most_spheres; ++i)
        text += "0 0 0 1\n";
    CHECK(refusal(text) == "cone.csv:4001:1: more than 4000 spheres");
}

} // namespace test_read_clump
