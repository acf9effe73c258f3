#include "taught.h"

#include <cmath>
#include <numbers>

namespace test_repose {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;

TEST_CASE("repose: friction makes a heap, shape makes it steeper, and discs stay below the angle of friction") {
    const Walk walk = taught("repose");
    // What knows no friction still has hollows.
    CHECK(walk.fact("angle_smooth") < 10);
    CHECK(walk.fact("angle_discs") > walk.fact("angle_smooth"));
    CHECK(walk.fact("angle_wedges") > walk.fact("angle_discs"));
    CHECK(walk.fact("angle_discs") < std::atan(0.5) * 180 / std::numbers::pi);
    for (const char* kind : {"angle_discs", "angle_wedges"}) // fills differ, by less than shape does
        CHECK(walk.fact(std::string(kind) + "_scatter") < walk.fact("angle_wedges") - walk.fact("angle_discs"));
}

} // namespace test_repose
