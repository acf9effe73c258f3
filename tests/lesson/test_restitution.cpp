#include "about.h"
#include "taught.h"

#include <cmath>
#include <numbers>

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("restitution: an impact is half a swing of the damped oscillator") {
    const double e = 0.5, v = 0.8, k = 2e5, m = 1.5; // -, m/s, N/m, kg
    const Walk walk =
        taught("restitution",
               {{"restitution", "0.5"}, {"speed_m_s", "0.8"}, {"normal_stiffness_N_per_m", "2e5"}, {"mass_kg", "1.5"}});
    const double zeta = -std::log(e) / std::hypot(std::log(e), std::numbers::pi);
    const double w = std::sqrt(k / m), damped = w * std::sqrt(1 - zeta * zeta);
    CHECK(walk.fact("restitution") == about(e, 2e-3));
    CHECK(walk.fact("duration") == about(std::numbers::pi / damped, 2e-3));
    CHECK(walk.fact("overlap") == about(v / w * std::exp(-zeta * std::acos(zeta) / std::sqrt(1 - zeta * zeta)), 2e-3));
}

TEST_CASE("restitution: both laws give back what was asked for, and Hertz' durations are those of theory") {
    const Walk walk = taught("restitution");
    CHECK(walk.fact("restitution_worst") < 5e-3);
    CHECK(walk.fact("hertz_worst") < 2e-3);
}

TEST_CASE("restitution: a contact that may not pull rebounds as Schwager and Pöschel say") {
    const double zeta = -std::log(0.3) / std::hypot(std::log(0.3), std::numbers::pi);
    const double root = std::sqrt(1 - zeta * zeta);
    const double angle = std::atan2(2 * zeta * root, 1 - 2 * zeta * zeta);
    const double expected = std::exp(-zeta / root * (std::numbers::pi - angle));
    CHECK(taught("restitution").fact("limited_restitution") == about(expected, 5e-3));
}
