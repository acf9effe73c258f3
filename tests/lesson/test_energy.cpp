#include "about.h"
#include "taught.h"

#include <cmath>
#include <numbers>

namespace test_energy {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("energy: a ball comes back to e^2 and e^4 of its height, and the books close") {
    const double h = 0.15, e = 0.8, r = 4e-3; // m, -, m
    const Walk walk = taught("energy", {{"height_mm", "150"}, {"restitution", "0.8"}, {"radius_mm", "4"}});
    const double energy = 4.0 / 3 * std::numbers::pi * r * r * r * 1665.71 * 9.81 * h;
    CHECK(walk.fact("energy") == about(energy, 1e-9));
    // Gravity goes on pulling during the contact: a part of a percent.
    CHECK(walk.fact("height_1") == about(e * e * h, 0.01));
    CHECK(walk.fact("height_2") == about(std::pow(e, 4) * h, 0.02));
    CHECK(walk.fact("lost_first") == about((1 - e * e) * energy, 0.01));
    CHECK(walk.fact("closure") < 1e-3); // a hundred steps a contact, second order
    CHECK(walk.fact("closure_coarse") > 0.01);
    // What gravity takes and the steps may: that is all that parts the bounce from e^2.
    const double seen = walk.fact("height_1") / (e * e * h) - 1, gravity = walk.fact("departure_gravity");
    CHECK(gravity < 0);
    CHECK(seen > gravity + walk.fact("departure_least") - 1e-3);
    CHECK(seen < gravity + walk.fact("departure_most") + 1e-3);
}

} // namespace test_energy
