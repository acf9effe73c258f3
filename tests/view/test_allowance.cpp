#include "view/allowance.h"

#include <doctest/doctest.h>

using namespace tumble::view;

namespace test_allowance {

TEST_CASE("so many come at once, then one whenever its share of a second has passed, and no more are saved up") {
    const Allowance::Clock::time_point begun;
    Allowance allowance(10, begun);
    const auto taken_at = [&](int ms) {
        int count = 0;
        while (allowance.take(begun + std::chrono::milliseconds(ms)))
            ++count;
        return count;
    };
    CHECK(taken_at(0) == 10);
    CHECK(taken_at(50) == 0); // half a share
    CHECK(taken_at(125) == 1);
    CHECK(taken_at(425) == 3);
    CHECK(taken_at(60000) == 10);
}

} // namespace test_allowance
