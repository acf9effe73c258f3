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

TEST_CASE(
    "clumps: spheres pack between the closest and the loosest random packing, and friction keeps every body loose") {
    const Walk walk = taught("clumps");
    // Random close packing leaves 0.36 empty (Scott 1960), random loose packing 0.445 (Onoda and Liniger 1990). Soft
    // spheres without friction may lie a little closer, and a layer of 60 bodies scatters by 0.02.
    CHECK(walk.fact("voidage_spheres_smooth") > 0.31);
    CHECK(walk.fact("voidage_spheres_smooth") < 0.38);
    CHECK(walk.fact("voidage_spheres") > 0.37);
    CHECK(walk.fact("voidage_spheres") < 0.445);
    CHECK(walk.fact("voidage_spheres") > walk.fact("voidage_spheres_smooth") + 0.02);
    CHECK(walk.fact("voidage_cones") > walk.fact("voidage_cones_smooth") + 0.04);
    CHECK(walk.fact("voidage_cones_smooth") < 0.34);
}
