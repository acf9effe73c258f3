#include "about.h"
#include "taught.h"

#include <cmath>
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
    CHECK(taught("clumps").fact("mass_worst") < 1e-6);
}
