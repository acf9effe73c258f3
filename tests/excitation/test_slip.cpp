#include "../folder.h"
#include "about.h"
#include "excitation/slip.h"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>

namespace test_slip {

using namespace tumble;
using namespace tumble::excitation;
using tumble::test::about;

namespace {

const std::filesystem::path printed_lines = std::filesystem::path(TUMBLE_ROOT) / "scenes/excitation/trough-vm375y.csv";

/// Lines at these orders of a fundamental and one of a mode at 77.3 Hz, printed as a transform over 1.28 s would.
std::string printed(double fundamental, const std::vector<double>& orders) {
    const double bin = 0.78125;
    std::string text = "axis,amplitude,period\n";
    for (const double order : orders)
        text += fmt::format("y,1e-5,{:.6e}\n", 1 / (bin * std::round(order * fundamental / bin)));
    return text + fmt::format("x,1e-7,{:.6e}\n", 1 / (99 * bin));
}

} // namespace

TEST_CASE("the lines that the thesis printed were made by a motor that turned 24.609 to 24.665 Hz") {
    const auto found = find_slip(test::content_of(printed_lines), printed_lines.string(), {});
    REQUIRE_MESSAGE(found.ok(), to_string(found.problems()));
    CHECK(found->bin == about(0.78125, 1e-6));
    CHECK(found->nominal == about(25));
    // By hand: bin 95 as order 3 allows (94.5 to 95.5) 0.78125 / 3, bin 110 as 7/2 (109.5 to 110.5) 0.78125 / 3.5; of
    // all seven these leave the least. Bin 32 as order 1 has the same lower end, 31.5 * 0.78125.
    CHECK(found->fundamental.lo == about(94.5 * 0.78125 / 3, 1e-6));
    CHECK(found->fundamental.hi == about(110.5 * 0.78125 / 3.5, 1e-6));
    CHECK(found->fundamental.lo == about(24.609, 1e-4));
    CHECK(found->fundamental.hi == about(24.665, 1e-4));
    CHECK(found->orders == 7);
    CHECK(found->at_nominal == 3); // 25 Hz itself: 12.5, 25 and 100 Hz
    for (const BinnedLine& line : found->lines) {
        const bool mains = std::abs(line.frequency - 100) < 0.1, mode = std::abs(line.frequency - 76.56) < 0.1;
        CHECK(line.multiple == (mains ? 2 : 0));
        CHECK((line.halves == 0) == (mains || mode));
    }
}

TEST_CASE("the chance that bins off by up to two agree is counted, not guessed") {
    const double chance = find_slip(test::content_of(printed_lines), printed_lines.string(), {})->chance;
    // A whole number of the 5^7 ways.
    const double ways = chance * std::pow(5, 7);
    CHECK(ways == about(std::round(ways), 1e-9));
    CHECK(std::lround(ways) == 15); // counted beside by another program: 1.9e-4
    // Three low orders agree often: that is no evidence.
    CHECK(find_slip(printed(25, {0.5, 1, 1.5}), "few.csv", {})->chance > 0.1);
}

TEST_CASE("the interval holds the fundamental that made the list, whatever it was") {
    for (const double fundamental : {23.3, 24.2, 24.637, 24.95, 25.8}) {
        const auto found = find_slip(printed(fundamental, {0.5, 1, 1.5, 2, 3, 4, 4.5, 5}), "made.csv", {.motor = 25});
        REQUIRE(found.ok());
        CAPTURE(fundamental);
        CHECK(found->fundamental.lo <= fundamental);
        CHECK(found->fundamental.hi >= fundamental);
        CHECK(found->fundamental.hi - found->fundamental.lo < 0.2);
    }
}

TEST_CASE("a line half-way between two bins is shown at 2/pi of its amplitude, at 8/(3 pi) with Hann's window") {
    CHECK(shown_without_window(0.5) == about(2 / 3.14159265));
    CHECK(shown_with_hann(0.5) == about(8 / (3 * 3.14159265)));
    CHECK(shown_without_window(0) == 1);
}

TEST_CASE("a list is known by its head, and one that was not rounded to bins is refused") {
    CHECK(is_line_list("# note\n\naxis,amplitude,period\ny,1,2\n"));
    CHECK_FALSE(is_line_list("t_s,ay_g\n0,1\n"));
    const auto free = find_slip("axis,amplitude,period\ny,1,0.0401234\ny,1,0.0213457\ny,1,0.0131313\n", "free.csv", {});
    REQUIRE_FALSE(free.ok());
    CHECK(free.problems()[0].what == "the frequencies are no multiples of one bin width");
}

} // namespace test_slip
