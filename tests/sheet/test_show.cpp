#include "sheet/show.h"

#include <doctest/doctest.h>

namespace test_show {

using namespace tumble::sheet;

TEST_CASE("lines break between words, and letters are counted, not bytes") {
    CHECK(letters("Δt ≤ 2/ω") == 8);
    CHECK(wrapped("one two three", 7) == "one two\nthree\n");
    CHECK(wrapped("ααα βββ γγγ", 7, "") == "ααα βββ\nγγγ\n");
}

TEST_CASE("a number that is rounding beside what its column's are parts of reads 0, and no other does") {
    const Grid grid{{{"free"}, {"part", "", 3, 2.0}}, {{1e-15, 1e-15}, {-1e-15, -1e-15}, {1e-11, 1e-11}}};
    const std::string text = to_text("t", {{grid}});
    CHECK(text.find("1e-15   0\n") != std::string::npos);
    CHECK(text.find("-1e-15  0\n") != std::string::npos);
    CHECK(text.find("1e-11   1e-11\n") != std::string::npos);
}

} // namespace test_show
