#include "about.h"
#include "taught.h"

#include <cmath>
#include <numbers>

namespace test_soft_and_hard {

using tumble::test::about;
using namespace tumble::lesson;
using namespace tumble::lesson::testing;

TEST_CASE(
    "soft-and-hard: both rebound alike, but only the soft impact has a duration, and only its force is the law's") {
    const Walk walk = taught("soft-and-hard", {{"restitution", "0.5"}, {"normal_stiffness_N_per_m", "5e4"}});
    CHECK(walk.fact("soft_restitution") == about(0.5, 5e-3));
    CHECK(walk.fact("hard_restitution") == about(0.5, 1e-4));
    // Half a swing of the damped oscillator of 10 g.
    const double zeta = std::log(2) / std::hypot(std::log(2), std::numbers::pi);
    const double half = std::numbers::pi / std::sqrt(5e4 / 0.01 * (1 - zeta * zeta));
    CHECK(walk.fact("soft_contact_time") == about(half, 0.01));
    // Its force k n + c n' is -m n'', largest where n''' = 0; stepped by hand with 1e6 steps a radian for the damping
    // ratio 0.2155: 0.8164 m v w.
    CHECK(walk.fact("soft_force_predicted") == about(0.8164 * 0.01 * std::sqrt(5e4 / 0.01), 1e-3));
    CHECK(walk.fact("soft_force") == about(walk.fact("soft_force_predicted"), 5e-3));
    CHECK(walk.fact("hard_force_ratio") == about(2, 1e-4)); // J / dt at half the step
    CHECK(walk.fact("hard_impulse") == about(0.01 * 1.5, 1e-4));
}

TEST_CASE("soft-and-hard: n springs are more damped than one, n hard contacts are not") {
    const Walk walk = taught("soft-and-hard");
    const double e = 0.667;
    for (const int n : {1, 2, 4}) {
        const double zeta = std::sqrt(n) * -std::log(e) / std::hypot(std::log(e), std::numbers::pi);
        const std::string discs = std::to_string(n);
        CHECK(walk.fact("soft_landing_" + discs) ==
              about(std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta)), 0.01));
        CHECK(walk.fact("hard_landing_" + discs) == about(e, 1e-3));
    }
}

TEST_CASE("soft-and-hard: one disc strikes two; hard contacts that touch act at once, with a gap one after the other") {
    const Walk walk = taught("soft-and-hard");
    CHECK(walk.fact("hard_touching_striker") == about(-1.0 / 3, 1e-3));
    CHECK(walk.fact("hard_touching_last") == about(2.0 / 3, 1e-3));
    CHECK(std::abs(walk.fact("hard_apart_striker")) < 1e-3);
    CHECK(walk.fact("hard_apart_last") == about(1, 1e-3));
    // Springs do not mind a millionth of a radius. Three masses on two springs part when neither is pressed any more:
    // integrated by hand with 1e6 steps that leaves the striker -0.1302 and the last 0.9800 of the speed.
    for (const char* gap : {"touching", "apart"}) {
        CHECK(walk.fact(std::string("soft_") + gap + "_striker") == about(-0.1302, 0.01));
        CHECK(walk.fact(std::string("soft_") + gap + "_last") == about(0.9800, 0.002));
    }
}

TEST_CASE("soft-and-hard: a column sinks by its weight over the stiffness, or by Box2D's slop; a block slides alike") {
    const Walk walk = taught("soft-and-hard", {{"friction", "0.3"}});
    CHECK(walk.fact("soft_sunk") == about(55 * 0.01 * 9.81 / 1e5, 0.01));
    const double slop = 0.005 * 0.01; // of one contact, m
    // "By up to its slop": ten contacts, each a few percent beyond it at most, and the lower ones not far below.
    CHECK(walk.fact("hard_sunk") > 5 * slop);
    CHECK(walk.fact("hard_sunk") < 10 * 1.05 * slop);
    for (const char* slide : {"soft_slide", "hard_slide"})
        CHECK(walk.fact(slide) == about(1 / (2 * 0.3 * 9.81), 0.01));
    CHECK(walk.fact("soft_steps") > 20 * walk.fact("hard_steps"));
    CHECK(walk.fact("hard_height") == about(walk.fact("soft_height"), 0.1));
}

} // namespace test_soft_and_hard
