#include "taught.h"

#include <cmath>
#include <numbers>

using namespace tumble::lesson;
using namespace tumble::lesson::testing;

TEST_CASE("friction: blocks and discs go down slopes as theory says, and a block slides from arctan mu on") {
    const Walk walk = taught("friction", {{"friction", "0.2"}});
    CHECK(walk.fact("worst_acceleration") < 2e-3); // of g
    CHECK(walk.fact("sliding_angle") == doctest::Approx(std::atan(0.2) * 180 / std::numbers::pi).epsilon(2e-3));
}

TEST_CASE("friction: a disc that slips rolls after v / (3 mu g) with two thirds of its speed") {
    const Walk walk = taught("friction", {{"friction", "0.4"}, {"speed_m_s", "2"}});
    CHECK(walk.fact("rolls_from") == doctest::Approx(2 / (3 * 0.4 * 9.81)).epsilon(0.01));
    CHECK(walk.fact("rolling_speed") == doctest::Approx(4.0 / 3).epsilon(2e-3));
}
