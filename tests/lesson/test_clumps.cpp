#include "about.h"
#include "taught.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>

namespace test_clumps {

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

TEST_CASE("clumps: the table shows what a landing gave back, and nothing for a body that does not come free") {
    // From zeta_n = 1 on it creeps out for ever: with e = 0.1 (zeta = 0.591) from four spheres on.
    const auto shown = [](const char* e) {
        std::vector<bool> numbers;
        for (const tumble::sheet::Part& part : taught("clumps", {{"restitution", e}}).parts)
            if (const auto* grid = std::get_if<Grid>(&part); grid && grid->columns[0].head == "spheres")
                for (const std::vector<Cell>& row : grid->rows)
                    numbers.push_back(std::holds_alternative<double>(row[1]));
        return numbers;
    };
    CHECK(shown("0.7") == std::vector{true, true, true, true});
    CHECK(shown("0.1") == std::vector{true, true, false, false});
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

TEST_CASE("clumps: a bed without a middle, or one that reaches the sky, is refused with how many bodies would do") {
    const auto fate = [](const char* bodies, const char* width) {
        const Lesson& lesson = **find_lesson("clumps");
        return lesson.teach(*read_values(lesson, {{"packing_bodies", bodies}, {"packing_width_mm", width}})).problems();
    };
    // 4 diameters of 17.5 mm on 300 mm squared, six tenths of it 2.806 cm3 each: 4 * 0.0175 * 0.09 * 0.6 / 2.806e-6 =
    // 1347.
    const auto flat = fate("60", "300");
    REQUIRE(flat.size() == 1);
    CHECK(flat[0].what.starts_with("60 bodies on 300 mm make a bed 0.18 sphere diameters deep"));
    CHECK(flat[0].fix.starts_with("take 1348 to 10"));
    CHECK(fate("4000", "50").size() == 1);
}

} // namespace test_clumps
