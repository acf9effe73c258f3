#include "about.h"
#include "taught.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace test_friction {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("friction: blocks and discs go down slopes as theory says, and a block slides from arctan mu on") {
    const Walk walk = taught("friction", {{"friction", "0.2"}});
    const double g = 9.81, mu = 0.2;
    for (const double share : {0.5, 0.95, 1.05, 1.5, 2.0, 2.8, 3.2, 4.0}) {
        CAPTURE(share);
        const double slope = std::atan(share * mu), slips = g * (std::sin(slope) - mu * std::cos(slope));
        const std::string at = fmt::format("_at_{}", share);
        CHECK(std::abs(walk.fact("block" + at) - std::max(0.0, slips)) < 2e-3 * g);
        CHECK(std::abs(walk.fact("disc" + at) - std::max(2.0 / 3 * g * std::sin(slope), slips)) < 2e-3 * g);
    }
    CHECK(walk.fact("sliding_angle") == about(std::atan(0.2) * 180 / std::numbers::pi, 2e-3));
}

TEST_CASE("friction: a disc that slips rolls after v / (3 mu g) with two thirds of its speed") {
    const Walk walk = taught("friction", {{"friction", "0.4"}, {"speed_m_s", "2"}});
    CHECK(walk.fact("rolls_from") == about(2 / (3 * 0.4 * 9.81), 2e-3));
    CHECK(walk.fact("rolling_speed") == about(4.0 / 3, 2e-3));
}

TEST_CASE(
    "friction: at flat impacts the shear dashpot takes friction beyond mu times the normal push, as theory says") {
    // sqrt(k_s / k_n) v_t / v_n over mu in the first moment, when both dashpots act alone. The impulse of an impact
    // that slides throughout, worked out by hand for the damping ratios 0, 0.1605, 0.3579 and 0.5052.
    const Walk walk = taught("friction");
    const auto impulses = [&](const char* e) { return walk.fact(std::string("grazing_impulses_of_e_") + e); };
    const auto forces = [&](const char* e) { return walk.fact(std::string("grazing_forces_of_e_") + e); };
    CHECK(impulses("1") == about(1, 2e-3));
    CHECK(impulses("0.6") == about(1.097, 0.01));
    CHECK(impulses("0.3") == about(1.546, 0.01));
    CHECK(impulses("0.159") == about(2.170, 0.05)); // eight times as fast along is not yet throughout: mu is 0.86
    CHECK(forces("1") == about(1, 0.01));
    CHECK(forces("0.6") == about(std::sqrt(0.7) * 8 / 0.5, 0.01));
    CHECK(forces("0.3") == about(std::sqrt(0.7) * 8 / 0.3, 0.01));
    CHECK(forces("0.159") == about(std::sqrt(0.7) * 8 / 0.86, 0.01));
}

} // namespace test_friction
