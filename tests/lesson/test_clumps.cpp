#include "about.h"
#include "taught.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("clumps: n contacts are sqrt(n) times as damped as one, unless they share") {
    const double e = 0.7;
    const Walk walk = taught("clumps", {{"restitution", "0.7"}});
    for (const int n : {1, 2, 4, 9}) {
        CAPTURE(n);
        const double zeta = std::sqrt(n) * -std::log(e) / std::hypot(std::log(e), std::numbers::pi);
        const double expected = std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta));
        CHECK(walk.fact("restitution_" + std::to_string(n)) == about(expected, 5e-3));
        CHECK(walk.fact("shared_restitution_" + std::to_string(n)) == about(e, 5e-3));
    }
}

TEST_CASE("clumps: mass is that of the union") {
    // Two spheres of radius R at d: both, less a lens of two caps of height R - d / 2.
    const double R = 5e-3, density = 1665.71;
    const Walk walk = taught("clumps");
    for (const double share : {0.25, 0.5, 1.0, 1.5, 2.0}) {
        CAPTURE(share);
        const double cap = R * (1 - share / 2);
        const double volume = std::numbers::pi * (8 * R * R * R - 2 * cap * cap * (3 * R - cap)) / 3;
        CHECK(walk.fact(fmt::format("mass_at_{}", share)) == about(volume * density, 1e-6));
    }
}
