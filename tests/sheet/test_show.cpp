#include "sheet/show.h"

#include <doctest/doctest.h>

namespace test_show {

using namespace tumble::sheet;

TEST_CASE("lines break between words, and letters are counted, not bytes") {
    CHECK(letters("Δt ≤ 2/ω") == 8);
    CHECK(wrapped("one two three", 7) == "one two\nthree\n");
    CHECK(wrapped("ααα βββ γγγ", 7, "") == "ααα βββ\nγγγ\n");
}

} // namespace test_show
