#include "about.h"
#include "taught.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace test_restitution {

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
    for (const double e : {1.0, 0.9, 0.7, 0.5, 0.3, 0.1}) {
        CAPTURE(e);
        CHECK(std::abs(walk.fact(fmt::format("linear_restitution_{}", e)) - e) < 5e-3);
        CHECK(std::abs(walk.fact(fmt::format("hertz_restitution_{}", e)) - e) < 5e-3);
    }
    // Johnson 1985, 11.22 and 11.24, against a plate of the same material, which is held but gives way as the sphere
    // does: 1 / E* = 2 (1 - nu^2) / E. It is flat, so R* = R, and cannot move, so m* = m.
    const double R = 5e-3, E_eff = 4.8e10 / (2 * (1 - 0.04)), mass = 4.0 / 3 * std::numbers::pi * R * R * R * 2800;
    for (const double v : {0.01, 0.1, 1.0, 4.0}) { // times 1 m/s
        CAPTURE(v);
        const double overlap = std::pow(15 * mass * v * v / (16 * E_eff * std::sqrt(R)), 0.4);
        const std::string at = fmt::format("{}", v);
        CHECK(walk.fact("hertz_overlap_" + at) == about(overlap, 2e-3));
        CHECK(walk.fact("hertz_duration_" + at) == about(2.9433 * overlap / v, 2e-3));
        CHECK(overlap < 0.01 * R); // Hertz: the contact is small against the sphere
    }
    CHECK(walk.fact("overlap") < 0.01 * R); // and so for the disc of the sphere's mass
}

TEST_CASE("restitution: a contact that may not pull rebounds as Schwager and Pöschel say") {
    const double zeta = -std::log(0.3) / std::hypot(std::log(0.3), std::numbers::pi);
    const double root = std::sqrt(1 - zeta * zeta);
    const double angle = std::atan2(2 * zeta * root, 1 - 2 * zeta * zeta);
    const double expected = std::exp(-zeta / root * (std::numbers::pi - angle));
    CHECK(taught("restitution").fact("limited_restitution") == about(expected, 5e-3));
}

TEST_CASE("restitution: a spring too soft for the impact is refused in the lesson's own words, with one that is stiff "
          "enough") {
    const auto lesson = find_lesson("restitution");
    REQUIRE(lesson.ok());
    const auto soft =
        read_values(**lesson, {{"normal_stiffness_N_per_m", "1e4"}, {"mass_kg", "1"}, {"speed_m_s", "2"}});
    REQUIRE(soft.ok());
    const auto refused = (*lesson)->teach(*soft);
    REQUIRE(!refused.ok());
    // 1 kg at 4 * 2 m/s sinks 8 / sqrt(1e4) = 0.08 m; half of the radius 0.1 m asks for (8 / 0.05)^2 N/m.
    CHECK(refused.problems()[0].what.find("sinks 0.08 m into the wall at 8 m/s") != std::string::npos);
    CHECK(refused.problems()[0].fix == "give a spring of at least 2.56e+04 N/m, less mass or less speed");
    const auto stiff =
        read_values(**lesson, {{"normal_stiffness_N_per_m", "2.6e4"}, {"mass_kg", "1"}, {"speed_m_s", "2"}});
    CHECK((*lesson)->teach(*stiff).ok());
}

} // namespace test_restitution
