#include "base/text.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <string>
#include <vector>

namespace test_text {

using namespace tumble;

TEST_CASE("trimming takes the blanks at both ends only") {
    CHECK(trimmed(" \t a b\r\n") == "a b");
    CHECK(trimmed(" \n ").empty());
}

TEST_CASE("n separators give n + 1 pieces") {
    CHECK(split("a,,b,", ',') == std::vector<std::string_view>{"a", "", "b", ""});
    CHECK(split("", ',') == std::vector<std::string_view>{""});
}

TEST_CASE("words are separated by any run of blanks") {
    CHECK(split_words("  x  y\tz\n") == std::vector<std::string_view>{"x", "y", "z"});
    CHECK(split_words(" \t").empty());
}

TEST_CASE("each typing mistake counts one, a swap of neighbours too") {
    CHECK(typing_distance("friction", "friction") == 0);
    CHECK(typing_distance("frictoin", "friction") == 1);
    CHECK(typing_distance("fiction", "friction") == 1);
    CHECK(typing_distance("frictionn", "friction") == 1);
    CHECK(typing_distance("kitten", "sitting") == 3);
    CHECK(typing_distance("", "abc") == 3);
    CHECK(typing_distance("ca", "abc") == 3); // no stretch is edited twice; the unrestricted distance would be 2
}

TEST_CASE("the nearest word is the one with fewest mistakes, none when all are far") {
    const std::vector<std::string> keys{"restitution", "friction", "rolling_friction", "density_kg_m3"};
    CHECK(nearest_word("frictoin", keys) == "friction");
    CHECK(nearest_word("density", keys) == std::nullopt);
    CHECK(nearest_word("density_kgm3", keys) == "density_kg_m3");
    CHECK(nearest_word("colour", keys) == std::nullopt);
    CHECK(nearest_word("", keys) == std::nullopt);
    CHECK(nearest_word("x", std::vector<std::string>{"y", "z"}) == "y");
    CHECK(did_you_mean("frictoin", keys) == "did you mean 'friction'?");
    CHECK(did_you_mean("colour", keys).empty());
    CHECK(nearest_word(std::string(100'000, 'a'), keys) == std::nullopt);
}

TEST_CASE("numbers are read whole or not at all") {
    CHECK(*parse_number("-0.5") == -0.5);
    CHECK(*parse_number("+2.5e-3") == 2.5e-3);
    CHECK(*parse_number("0.1") == 0.1);
    CHECK(*parse_number(".5") == 0.5);
    for (const char* wrong : {"", "+", "+-1", " 1", "1 ", "1,5", "0x10", "nan", "inf", "-inf", "1e999", "1.2.3", "--1"})
        CHECK_MESSAGE(!parse_number(wrong).ok(), wrong);
}

TEST_CASE("a number that stops being one says where") {
    const auto number = parse_number("1.5mm");
    REQUIRE(!number.ok());
    const Problem problem = number.problems().at(0);
    CHECK(problem.column == 4);
    CHECK(problem.what == "'1.5mm' is not a number: it stops being one at 'mm'");
    CHECK(problem.fix == "write a decimal number such as 12, -0.5 or 2.5e-3");
}

TEST_CASE("whole numbers know the range of 64 bits") {
    CHECK(*parse_integer("-9223372036854775808") == std::numeric_limits<std::int64_t>::min());
    CHECK(*parse_integer("+7") == 7);
    CHECK(parse_integer("9223372036854775808").problems().at(0).what ==
          "'9223372036854775808' is outside the range of a whole number");
    CHECK(parse_integer("12.5").problems().at(0).column == 3);
}

TEST_CASE("the shortest form reads back to the same bits") {
    for (const double value : {0.1, 1.0 / 3.0, 1e300, 5e-324, -0.0, 123456789.0, 2.2250738585072014e-308}) {
        const auto back = parse_number(shortest(value));
        REQUIRE(back.ok());
        CHECK(*back == value);
        CHECK(std::signbit(*back) == std::signbit(value));
    }
    CHECK(shortest(0.1) == "0.1");
    CHECK(shortest(40e-6) == "4e-05");
}

TEST_CASE("SI numbers get the prefix that leaves one to three digits before the point") {
    CHECK(format_si(40.34e-6, "s") == "40.34 us");
    CHECK(format_si(10696.9, "N") == "10.7 kN");
    CHECK(format_si(10696.9, "N", 6) == "10.6969 kN");
    CHECK(format_si(-2.5e9, "Pa") == "-2.5 GPa");
    CHECK(format_si(0, "m") == "0 m");
    CHECK(format_si(1e-15, "m") == "0.001 pm");
    CHECK(format_si(1, "s") == "1 s");
    CHECK(format_si(-0.0, "J") == "0 J");
}

TEST_CASE("rounding up to the next prefix changes the prefix") {
    CHECK(format_si(999.96e-6, "m") == "1 mm");
    CHECK(format_si(999.94e-6, "m") == "999.9 um");
    CHECK(format_si(1000, "s") == "1 ks");
    CHECK(format_si(1e-3, "m") == "1 mm");
}

TEST_CASE("masses are in kg or grams, compound units and angles take no prefix") {
    CHECK(format_si(4.675e-3, "kg") == "4.675 g");
    CHECK(format_si(12.5, "kg") == "12.5 kg");
    CHECK(format_si(2.5e-6, "kg") == "2.5 mg");
    CHECK(format_si(2700, "kg/m3") == "2700 kg/m3");
    CHECK(format_si(1e-9, "m3") == "1e-09 m3");
    CHECK(format_si(24.5, "deg") == "24.5 deg");
    CHECK(format_si(0.25, "") == "0.25");
    CHECK(format_si(std::nan(""), "N") == "nan N");
}

TEST_CASE("what rounds to zero has no sign") {
    CHECK(fixed(-0.0004, 3) == "0.000");
    CHECK(fixed(-0.0, 1) == "0.0");
    CHECK(fixed(-0.4, 0) == "0");
    CHECK(fixed(-0.0006, 3) == "-0.001");
    CHECK(fixed(12.25, 1) == "12.2");
    CHECK(fixed(std::nan(""), 1) == "nan");
}

TEST_CASE("messages show the beginning of a text, without control characters") {
    CHECK(excerpt("abc") == "abc");
    CHECK(excerpt("abcdef", 3) == "abc...");
    CHECK(excerpt(std::string_view("a\0\x1b", 3)) == "a??");
    CHECK(parse_number(std::string(1'000'000, 'x')).problems().at(0).what.size() < 200);
}

} // namespace test_text
