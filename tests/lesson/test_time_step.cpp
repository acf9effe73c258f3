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
                  .fact("force_of_50_steps") == about(1, 2e-3));
}

TEST_CASE("time-step: fifty steps in a contact give the peak force to two in a thousand") {
    CHECK(taught("time-step").fact("force_of_50_steps") == about(1, 2e-3));
}

} // namespace test_time_step
