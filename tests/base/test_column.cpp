#include "base/column.h"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace test_column {

using namespace tumble;

TEST_CASE("the longest run at an extreme is found where it is, not runs elsewhere") {
    const std::vector<double> column{0, 1, 1, 1, 1, 0, 2, 2, 0, -1, -1, -1, 1};
    const Stretch stretch = longest_at_extreme(column);
    CHECK(stretch.first == 9);
    CHECK(stretch.length == 3);
    CHECK(longest_at_extreme({}).length == 0);
}

TEST_CASE("levels are counted up to what was asked for") {
    const std::vector<double> column{1, 2, 1, 2, 3, 3, 4};
    CHECK(distinct_levels(column, 10) == 4);
    CHECK(distinct_levels(column, 2) == 3);
}

TEST_CASE("the middle value does not care for one that is far off") {
    CHECK(median({3, 1, 1e9}) == 3);
    CHECK(median({}) == 0);
}

TEST_CASE("the spread of values is that of samples, n - 1") {
    CHECK(spread_of(std::vector{1.0, 2.0, 6.0}).mean == 3);
    CHECK(spread_of(std::vector{1.0, 2.0, 6.0}).deviation == std::sqrt(7.0)); // (4 + 1 + 9) / 2
    CHECK(spread_of(std::vector{5.0}).deviation == 0);
}

} // namespace test_column
