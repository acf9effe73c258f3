#include "sheet/show.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <sstream>

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

TEST_CASE("a grid that would be wider than 120 letters breaks its heads and goes on below, rows named again") {
    Grid grid;
    grid.columns.push_back({"scene"});
    for (const char* name : {"softening 4, spheres 0.3, slice 0.5, size 1.5", "as written"})
        grid.rows.push_back({std::string(name)});
    for (int k = 10; k < 20; ++k) {
        grid.columns.push_back({"mean speed of layer " + std::to_string(k), "m/s"});
        for (auto& row : grid.rows)
            row.emplace_back("(+" + std::to_string(k) + " ± 35 %)");
    }
    const std::string text = to_text("t", {{grid}});
    std::size_t widest = 0, named = 0, columns = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        widest = std::max(widest, letters(line));
        named += line.starts_with("  as written") ? 1 : 0;
    }
    for (int k = 10; k < 20; ++k) {
        const std::size_t cell = text.find("(+" + std::to_string(k) + " ± 35 %)");
        columns += cell != std::string::npos && text.find(std::to_string(k) + ",") < cell ? 1 : 0;
    }
    CHECK(widest <= 120);
    CHECK(columns == 10);
    CHECK(text.find("size 1.5") != std::string::npos);
    // Names break at 24 letters and columns are as wide as their cells, 12: 2 + 24 + 10 * 14 = 166 letters, two blocks.
    CHECK(named == 2);
}

TEST_CASE("a grid that fits stands as it is, blanks within its cells too") {
    Grid grid;
    grid.columns.push_back({"a  b"});
    grid.columns.push_back({"c", "m"});
    grid.rows.push_back({std::string("one  two"), 1.5});
    CHECK(to_text("t", {{grid}}) == "t\n=\n\n  a  b      c, m\n  one  two  1.5\n");
}

} // namespace test_show
