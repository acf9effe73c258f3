#include "about.h"
#include "render/color_range.h"
#include "render/panels.h"
#include "render/ticks.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace test_ticks {

using namespace tumble::render;
using tumble::test::about;

TEST_CASE("round numbers are 1, 2, 2.5 or 5 times a power of ten") {
    CHECK(round_up(0.3) == about(0.5));
    CHECK(round_up(0.2) == about(0.2));
    CHECK(round_up(2.1) == about(2.5));
    CHECK(round_up(7) == about(10));
    CHECK(round_down(7) == about(5));
    CHECK(round_down(0.49) == about(0.2));
    CHECK(round_down(1000) == about(1000));
}

TEST_CASE("ticks meet both ends of a round span") {
    CHECK(ticks_in({0, 50}, 3) == std::vector<double>{0, 25, 50});
    CHECK(ticks_in({-1, 1}, 5) == std::vector<double>{-1, -0.5, 0, 0.5, 1});
    CHECK(ticks_in({0, 0.2}, 2).size() == 2);
}

TEST_CASE("ticks lie inside any span, never fewer than two and never more than asked for") {
    CHECK(ticks_in({-7.5, 5}, 2) == std::vector<double>{-5, 5}); // multiples of 10 are one only: 0
    for (const double lo : {-7.5, -3.3, -0.017, 0.0, 1234.5}) {
        for (const double width : {1e-6, 0.7, 12.5, 13.0, 99000.0}) {
            for (const int most : {2, 3, 6, 9}) {
                const auto ticks = ticks_in({lo, lo + width}, most);
                CHECK(ticks.size() <= static_cast<std::size_t>(most));
                CHECK(ticks.size() >= 2);
                CHECK(ticks.front() >= lo - 1e-6 * width);
                CHECK(ticks.back() <= lo + width * (1 + 1e-6));
            }
        }
    }
}

TEST_CASE("tick labels have the digits that their step needs") {
    CHECK(tick_labels({0, 0.05, 0.1}) == std::vector<std::string>{"0.00", "0.05", "0.10"});
    CHECK(tick_labels({-20, 0, 20}) == std::vector<std::string>{"\u221220", "0", "20"});
    CHECK(tick_labels({-2.5, 2.5}) == std::vector<std::string>{"\u22122.5", "2.5"});
    CHECK(tick_labels({0, 2.5, 5}) == std::vector<std::string>{"0.0", "2.5", "5.0"});
}

TEST_CASE("units take a prefix when the numbers would be small or large") {
    const DisplayUnit slow = display_unit("m/s", {0, 0.05});
    CHECK(slow.unit == "mm/s");
    CHECK(0.05 * slow.factor == about(50));
    CHECK(display_unit("m/s", {0, 0.5}).unit == "m/s");
    CHECK(display_unit("m/s", {-2e-5, 2e-5}).unit == "\u00b5m/s");
    CHECK(display_unit("J", {0, 5000}).unit == "kJ");
    CHECK(display_unit("rad/s", {0, 5000}).unit == "10\u00b3 rad/s");
    CHECK(display_unit("", {0, 0.002}).unit == "10\u207b\u00b3");
    CHECK(display_unit("kg", {0, 0}).unit == "kg");
}

TEST_CASE("an automatic range is round, holds 98 % of the bodies and is not taken by a few fast ones") {
    std::vector<double> speeds(1000, 0.3);
    speeds[7] = 50;
    CHECK(ColorRange(std::nullopt, false).next(speeds) == Span{0, 0.5});
    CHECK(ColorRange(std::nullopt, true).next(speeds) == Span{-0.5, 0.5});
}

TEST_CASE("an automatic range passes over what is not a number and survives a bulk at rest") {
    ColorRange range(std::nullopt, false);
    CHECK(range.next({}) == Span{0, 1});
    CHECK(range.next({0, 0, 0}) == Span{0, 1});
    CHECK(range.next({std::nan(""), std::numeric_limits<double>::infinity(), 0.15}) == Span{0, 0.2});
}

TEST_CASE("an automatic range grows at once and shrinks only after 25 quiet frames") {
    ColorRange range(std::nullopt, false);
    CHECK(range.next({0.1}) == Span{0, 0.1});
    CHECK(range.next({0.9}) == Span{0, 1});
    for (int i = 0; i < 24; ++i) {
        CHECK(range.next({0.1}) == Span{0, 1});
    }
    CHECK(range.next({0.1}) == Span{0, 0.1});
    // A single livelier frame starts the count again.
    range.next({0.9});
    for (int i = 0; i < 60; ++i) {
        CHECK(range.next({i % 20 == 19 ? 0.5 : 0.1}) == Span{0, 1});
    }
}

TEST_CASE("a frame that is looked at again and again does not wear the patience of its range") {
    ColorRange range(std::nullopt, false);
    CHECK(range.next({0.9}, 0.0) == Span{0, 1});
    for (int i = 0; i < 60; ++i)
        CHECK(range.next({0.1}, 0.5) == Span{0, 1});
    for (int i = 1; i < 24; ++i)
        CHECK(range.next({0.1}, 0.5 + i) == Span{0, 1});
    CHECK(range.next({0.1}, 50.0) == Span{0, 0.1}); // the 25th frame
}

TEST_CASE("what is slower than 1 nm/s is at rest, but forces of small grains may be as small") {
    CHECK(ColorRange(std::nullopt, false).next({2e-10}) == Span{0, 1});
    CHECK(ColorRange(std::nullopt, false, 0).next({2e-10}).hi == about(2e-10));
}

TEST_CASE("one range for many frames is the widest of theirs, also where that is 1, and frames at rest do not count") {
    const auto of = [](const std::vector<std::vector<double>>& frames) {
        WidestRange widest;
        for (const std::vector<double>& values : frames)
            widest.take_in(values);
        return widest.span(false);
    };
    CHECK(of({{0.3}, {0.9}, {0.1}}) == Span{0, 1}); // 0.9 asks for a scale to 1
    CHECK(of({{0}, {0.3}, {}}) == Span{0, 0.5});    // of 0 alone it would reach to 1, too
    CHECK(of({{0}}) == Span{0, 1});
    WidestRange signs;
    signs.take_in({-0.15, 0.1});
    CHECK(signs.span(true) == Span{-0.2, 0.2});
}

TEST_CASE("a fixed range stays") {
    ColorRange range(Span{-2, 3}, false);
    CHECK(range.next({100}) == Span{-2, 3});
}

TEST_CASE("the time stamp has the digits that the frames need") {
    CHECK(time_stamp(1.24, 0.04) == "t = 1.24 s");
    CHECK(time_stamp(1.2345, 0.0005) == "t = 1.2345 s");
    CHECK(time_stamp(2, 1) == "t = 2.00 s");
}

} // namespace test_ticks
