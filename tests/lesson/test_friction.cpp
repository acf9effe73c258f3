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

} // namespace test_friction
