#include "about.h"
#include "observe/impacts.h"

#include <doctest/doctest.h>

namespace test_impacts {

using namespace tumble::observe;
using tumble::test::about;

TEST_CASE("impact steps and the sliding steps after them are told apart, body by body") {
    const auto touch = [](std::int64_t body, int number, double normal, double shear) {
        Touching made;
        made.body = body;
        made.number = number;
        made.peak_normal = normal;
        made.peak_shear = shear;
        made.normal_impulse = 1e-3 * normal;
        made.shear_impulse = 1e-3 * shear;
        return made;
    };
    // Body 4 slides after its impact and presses harder then; body 9 in between presses once; body 4 comes back and is
    // weaker after its impact. A run that begins in the midst may begin with a later number.
    const Impacts impacts = impacts_of({touch(4, 1, 2, 1), touch(9, 1, 8, 9), touch(4, 2, 3, 1), touch(4, 1, 5, 1),
                                        touch(4, 2, 4, 1), touch(4, 3, 3, 1), touch(6, 2, 1, 0)});
    CHECK(impacts.touches == 7);
    CHECK(impacts.normal_above == 6);
    CHECK(impacts.rows == 4);
    CHECK(impacts.slid == 2);
    CHECK(impacts.first_strongest == 1);
    CHECK(impacts.impact_normal == about((2 + 8 + 5 + 1) / 4.0));
    CHECK(impacts.sliding_normal == about((3 + 4 + 3) / 3.0));
    CHECK(impacts.normal_impulse == about(26e-3));
    CHECK(impacts.shear_impulse == about(14e-3));
    REQUIRE(impacts.hardest.size() == 1);
    CHECK(impacts.hardest[0].body == 9);
    const Impacts none = impacts_of({});
    CHECK(none.rows == 0);
    CHECK(none.impact_normal == 0);
    CHECK(none.hardest.empty());
}

} // namespace test_impacts
