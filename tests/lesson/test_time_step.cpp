#include "about.h"
#include "taught.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace test_time_step {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("time-step: a disc between two springs explodes from 2 / omega on, not before") {
    const double limit = 2 / std::sqrt(2 * 1e5 / 1.0); // s
    const Walk walk = taught("time-step");
    CHECK(walk.fact("limit_predicted") == about(limit, 1e-12));
    CHECK(walk.fact("limit_seen") == about(limit, 2e-5));
    // Roots of r^2 = p r - 1 with p = 2 - (w dt)^2: on the unit circle up to w dt = 2, one outside beyond.
    for (const double factor : {0.1, 0.5, 0.99, 1.01, 1.1, 1.2}) {
        CAPTURE(factor);
        const double half = std::abs(1 - 2 * factor * factor);
        const double growth = half > 1 ? half + std::sqrt(half * half - 1) : 1;
        CHECK(walk.fact(fmt::format("growth_at_{}", factor)) == about(growth, 1e-6));
    }
    CHECK(walk.fact("check_limit") < limit);
}

TEST_CASE("time-step: dashpots bring the limit down") {
    const double e = 0.6, ln_e = std::log(e);
    const double zeta = std::sqrt(2.0) * -ln_e / std::hypot(ln_e, std::numbers::pi); // two dashpots, two springs
    const double limit = 2 / std::sqrt(2 * 1e5 / 1.0) * (std::sqrt(1 + zeta * zeta) - zeta);
    const Walk walk = taught("time-step", {{"restitution", "0.6"}});
    CHECK(walk.fact("limit_seen") == about(limit, 2e-3));
}

TEST_CASE("time-step: the softest spring with the largest mass makes the lesson, and so do their opposites") {
    for (const auto& [stiffness, mass] : {std::pair{"1", "1000"}, std::pair{"1e9", "1e-6"}}) // slowest, fastest swing
        CHECK(taught("time-step", {{"normal_stiffness_N_per_m", stiffness}, {"mass_kg", mass}})
                  .fact("force_error_of_50_steps") < 2e-3);
}

TEST_CASE("time-step: what an impact of few steps gives back depends on where in a step it begins, to either side") {
    // Leapfrog runs backwards on its own track: an impact that gives back e is, from its end, one that gives back 1 /
    // e, so that least and most are each other's inverse. The peak is a sine read four times a half swing, off its top
    // by up to half a step: from cos(pi / 8) = 0.924 of the swing, whose size differs by as much as e does.
    const Walk walk = taught("time-step");
    const double least = walk.fact("least_restitution_of_4_steps"), most = walk.fact("most_restitution_of_4_steps");
    CHECK(most > 1.02);
    CHECK(least * most == about(1, 2e-3));
    CHECK(walk.fact("force_error_of_4_steps") == about(1 - std::cos(std::numbers::pi / 8), 0.2));
    CHECK(walk.fact("force_error_of_50_steps") < 2e-3);
}

TEST_CASE("time-step: at the limit the double root lets a disc with a speed come further by one way in every step") {
    CHECK(taught("time-step").fact("ways_at_the_limit") ==
          about(20, 1e-6)); // x_k = k x_1 (-1)^k of x_k+1 = -2 x_k - x_k-1
}

TEST_CASE("time-step: the heap's limit is that of four contacts of discs that turn, 1 / sqrt 12 of the cage's") {
    // w^2 = 4 k (1/m + R^2/I) of two discs = 24 k / m, beside 2 k / m of a disc between two walls.
    const Walk walk = taught("time-step");
    CHECK(walk.fact("heap_limit") == about(walk.fact("limit_predicted") / std::sqrt(12.0), 1e-9));
    for (std::size_t side : {0U, 1U})
        CHECK(walk.films[0].reels[side].label ==
              (side == 0 ? "step 0.7 of the heap's limit" : "step 2.8 of the heap's limit"));
}

TEST_CASE(
    "time-step: the Rayleigh time knows neither speed nor mass, the limit falls with v^(1/5) and grows with m^(2/5)") {
    const Walk walk = taught("time-step");
    const double shear_modulus = 4.6e8 / (2 * 1.2887);
    const double wave = std::numbers::pi * 2e-3 * std::sqrt(1665.71 / shear_modulus) / (0.1631 * 0.2887 + 0.8766);
    CHECK(walk.fact("rayleigh_time") == about(wave, 1e-9));
    CHECK(walk.fact("bead_limit_at_0.1") / walk.fact("bead_limit_at_10") == about(std::pow(100, 0.2), 1e-6));
    CHECK(walk.fact("heavy_bead_limit_at_1") / walk.fact("bead_limit_at_1") == about(std::pow(10, 0.4), 1e-6));
}

} // namespace test_time_step
