#include "solver/grouped.h"

#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

namespace test_grouped {

using namespace tumble;

TEST_CASE("entries are found by key, in the order in which they were added, and a second grouping forgets the first") {
    solver::Grouped<std::pair<int, char>> grouped;
    const auto by_first = [](const auto& entry) { return entry.first; };
    for (const auto& entry : std::vector<std::pair<int, char>>{{2, 'a'}, {0, 'b'}, {2, 'c'}, {1, 'd'}, {2, 'e'}})
        grouped.add(entry);
    grouped.group(4, by_first);
    std::string twos;
    for (const auto& entry : grouped.of(2))
        twos += entry.second;
    CHECK(twos == "ace");
    CHECK(grouped.of(0).size() == 1);
    CHECK(grouped.of(3).empty());
    CHECK(grouped.of(4).empty()); // a key that came later
    grouped.begin_anew();
    grouped.add({3, 'f'});
    grouped.group(4, by_first);
    CHECK(grouped.of(2).empty());
    CHECK(grouped.of(3)[0].second == 'f');
    grouped.forget();
    CHECK(grouped.of(3).empty());
}

} // namespace test_grouped
