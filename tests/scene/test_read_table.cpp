#include "about.h"
#include "scene/read_table.h"

#include <doctest/doctest.h>
#include <numbers>

namespace test_read_table {

using namespace tumble;
using namespace tumble::scene;
using tumble::test::about;

namespace {

template <class Content> std::string refusal(const Result<Content>& result) {
    const Problems problems = result.problems();
    return problems.empty()
               ? ""
               : to_string(Problem{problems[0].file, problems[0].line, problems[0].column, "", problems[0].what, ""});
}

std::string table_refusal(const std::string& rows) {
    return refusal(parse_motion_table("t_s,x_m,y_m,z_m\n" + rows, "m.csv"));
}

std::string harmonics_refusal(const std::string& text) {
    return refusal(parse_harmonics(text, "h.csv"));
}

} // namespace

TEST_CASE("a motion table holds times and displacements") {
    const auto table = parse_motion_table("# measured\nt_s,x_m,y_m,z_m\n0,0,0,0\n0.5,0.001,-2e-3,0\n", "m.csv");
    REQUIRE(table);
    CHECK(table->time == std::vector<double>{0, 0.5});
    CHECK(table->displacement[1] == Eigen::Vector3d(0.001, -0.002, 0));
}

TEST_CASE("a motion table that does not start at 0 or does not rise is refused at its row") {
    CHECK(table_refusal("0.1,0,0,0\n0.2,0,0,0\n") == "m.csv:2:1: the first time is 0.1, not 0");
    CHECK(table_refusal("0,0,0,0\n0,0,0,0\n") == "m.csv:3:1: time 0 does not rise above 0");
    CHECK(table_refusal("0,0,0,0\n") == "m.csv:2:1: a motion of 1 row, it needs 2");
    CHECK(table_refusal("0,0,0,0\n1,0,nan,0\n") != "");
    CHECK(table_refusal("0,0,0,0\n1,0,200,0\n") == "m.csv:3:5: 200 is not within -100 to 100");
    CHECK(refusal(parse_motion_table("t,x,y,z\n0,0,0,0\n", "m.csv")) ==
          "m.csv: the head is 't,x,y,z', not 't_s,x_m,y_m,z_m'");
}

TEST_CASE("the thesis' excitation file gives twelve harmonics without phase") {
    const auto harmonics = read_harmonics(TUMBLE_ROOT "/scenes/excitation/trough-vm375y.csv");
    REQUIRE(harmonics);
    CHECK(harmonics->size() == 12);
    for (const Harmonic& harmonic : *harmonics)
        CHECK(harmonic.phase == 0);
    CHECK((*harmonics)[0].frequency == about(12.5));
}

TEST_CASE("phases of harmonics are degrees in the file and radians inside") {
    const auto harmonics = parse_harmonics("axis,amplitude,period,phase_deg\nz,0.002,0.04,90\n", "h.csv");
    REQUIRE(harmonics);
    CHECK((*harmonics)[0].phase == about(std::numbers::pi / 2, 1e-15));
    CHECK((*harmonics)[0].axis == 2);
}

TEST_CASE("harmonics that cannot be are refused at their place") {
    CHECK(harmonics_refusal("axis,amplitude,period\ny,0.002,0\n") == "h.csv:2:9: 0 is not within 1e-06 to 1000000");
    CHECK(harmonics_refusal("axis,amplitude,period\ny,-1,0.04\n") == "h.csv:2:3: -1 is not within 0 to 100");
    CHECK(harmonics_refusal("axis,amplitude,period\nyz,1,0.04\n") == "h.csv:2:1: 'yz' is not an axis x, y or z");
    CHECK(harmonics_refusal("axis,amplitude,period\n") == "h.csv: 0 harmonics, not 1 to 10000");
}

} // namespace test_read_table
