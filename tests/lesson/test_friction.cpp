#include "about.h"
#include "taught.h"

#include <cmath>
#include <numbers>

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("friction: blocks and discs go down slopes as theory says, and a block slides from arctan mu on") {
    const Walk walk = taught("friction", {{"friction", "0.2"}});
    CHECK(walk.fact("worst_acceleration") < 2e-3); // of g
    CHECK(walk.fact("sliding_angle") == about(std::atan(0.2) * 180 / std::numbers::pi, 2e-3));
}

TEST_CASE("friction: a disc that slips rolls after v / (3 mu g) with two thirds of its speed") {
    const Walk walk = taught("friction", {{"friction", "0.4"}, {"speed_m_s", "2"}});
    CHECK(walk.fact("rolls_from") == about(2 / (3 * 0.4 * 9.81), 0.01));
    CHECK(walk.fact("rolling_speed") == about(4.0 / 3, 2e-3));
}
