#include "about.h"
#include "taught.h"

#include <cmath>

namespace test_force_law {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("force-law: the rig sees Hertz, Mindlin and Coulomb") {
    const double R = 2.5e-3, d = 50e-6, E = 5e7, nu = 0.25, mu = 0.3, s = 30e-6; // m, m, Pa, -, -, m
    const Walk walk = taught("force-law");
    const double E_eff = E / (2 * (1 - nu * nu)), G_eff = E / (4 * (2 - nu) * (1 + nu));
    const double force = 4.0 / 3 * E_eff * std::sqrt(R) * std::pow(d, 1.5);
    CHECK(walk.fact("hertz_force") == about(force));
    CHECK(walk.fact("hertz_work") == about(0.4 * force * d, 1e-4));
    CHECK(walk.fact("linear_work") == about(0.5 * force * d, 1e-9));
    const double slope = 8 * G_eff * std::sqrt(R * d), yield = mu * force / slope;
    CHECK(walk.fact("shear_slope") == about(slope));
    CHECK(walk.fact("shear_limit") == about(mu * force));
    CHECK(walk.fact("yield") == about(yield, 0.01)); // 400 steps resolve s / 400
    // In the steps that reach the limit the mean of two forces counts: 5 of some 2000.
    CHECK(walk.fact("loop_loss") == about(5 * mu * force * (s - yield), 1e-5));
    CHECK(walk.fact("loop_work") == about(walk.fact("loop_loss"), 1e-3));
    CHECK(walk.fact("beyond_limit") < 1e-12 * force);
}

TEST_CASE("force-law: grains that are drawn less far than the limit lose nothing") {
    const Walk walk = taught("force-law", {{"shear_um", "5"}});
    CHECK(walk.fact("loop_loss") == 0);
    CHECK(std::isnan(walk.fact("yield"))); // never slides
}

TEST_CASE("force-law: the spring is seen before it gives, however small its part of the way, or not at all") {
    const double R = 2.5e-3, d = 0.1e-6, E = 5e7, nu = 0.25, mu = 0.3;
    const Walk walk = taught("force-law", {{"overlap_um", "0.1"}});
    const double slope = 8 * E / (4 * (2 - nu) * (1 + nu)) * std::sqrt(R * d);
    const double force = 4.0 / 3 * E / (2 * (1 - nu * nu)) * std::sqrt(R) * std::pow(d, 1.5);
    CHECK(walk.fact("shear_slope") == about(slope, 1e-9));
    CHECK(walk.fact("yield") == about(mu * force / slope, 0.01));
    CHECK(taught("force-law", {{"friction", "0"}}).fact("shear_limit") == 0);
}

} // namespace test_force_law
