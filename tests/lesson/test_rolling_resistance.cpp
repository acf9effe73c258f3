#include "about.h"
#include "taught.h"

#include <cmath>

namespace test_rolling_resistance {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("rolling-resistance: without it a ball keeps its speed, with it it stops after 7 v^2 / (10 mu_r g)") {
    const Walk walk = taught("rolling-resistance", {{"rolling_friction", "0.1"}, {"speed_m_s", "0.5"}});
    const double distance = 7 * 0.5 * 0.5 / (10 * 0.1 * 9.81);
    CHECK(walk.fact("free_speed") == about(0.5, 1e-3));
    CHECK(walk.fact("stop_distance_cdt") == about(distance, 2e-3));
    // The dashpot takes 4 eta theta omega_r R / v of the energy while the spring is wound up, by hand: m = 0.08378 kg,
    // weight 0.8219 N, overlap 18.85 um, theta = 18.85e-6 / (2.25 * 0.1 * 0.02) = 4.189e-3 rad, omega_r = sqrt(2.25 *
    // 0.8219 / 18.85e-6 * 0.01 / (1.4 * 0.08378)) = 91.4 1/s: 4 * 0.3 * 4.189e-3 * 91.4 * 0.02 / 0.5 = 1.84 %; half the
    // winding, 0.04 mm, comes on top.
    CHECK(walk.fact("stop_distance_epsd") == about(distance * (1 - 0.0184) + 0.5 * 4.189e-3 * 0.02, 5e-3));
    CHECK(walk.fact("stop_distance_small") == about(distance, 2e-3));
}

TEST_CASE(
    "rolling-resistance: at rest the constant torque shakes the ball by what it gives in a step, the spring's fades") {
    const Walk walk = taught("rolling-resistance");
    CHECK(walk.fact("kicks_at_rest_cdt") == about(0.5, 0.02)); // a kick to and fro: half of it either way
    CHECK(walk.fact("kicks_at_rest_epsd") < 1e-3);
    CHECK(walk.fact("worst_acceleration") < 0.02); // of mu_r g
}

} // namespace test_rolling_resistance
