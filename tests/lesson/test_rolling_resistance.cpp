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
    CHECK(walk.fact("stop_distance_epsd") == about(walk.fact("stop_distance_theory_epsd"), 5e-3));
    CHECK(walk.fact("stop_distance_theory_epsd") == about(distance, 0.05));
    CHECK(walk.fact("stop_distance_small") == about(distance, 2e-3));
}

TEST_CASE(
    "rolling-resistance: at rest the constant torque shakes the ball by what it gives in a step, the spring's fades") {
    const Walk walk = taught("rolling-resistance");
    CHECK(walk.fact("spin_at_rest_cdt") > 0.4);
    CHECK(walk.fact("spin_at_rest_cdt") < 1.6);
    CHECK(walk.fact("spin_at_rest_epsd") < 1e-3);
    CHECK(walk.fact("worst_acceleration") < 0.02); // of mu_r g
}

} // namespace test_rolling_resistance
