#include "about.h"
#include "performed.h"

#include <cmath>
#include <variant>

namespace test_falls {

using namespace tumble;
using namespace tumble::lab;
using namespace tumble::lab::testing;
using tumble::test::about;

TEST_CASE("rebound heights give the restitution that the contact law was given, from any height and for a light ball") {
    // Gravity during the contact takes 0.3 % of the energy of the thesis' ball from 200 mm (scenes/drop.toml), less
    // from higher up: 0.0015 * 0.67 of e.
    const Outcome one = performed("drop", {{"heights", "1"}, {"bounces", "1"}});
    CHECK(one.sheet.fact("worst_restitution") < 0.003);
    CHECK(one.sheet.fact("first_rebound") == about(200 * 0.67 * 0.67, 0.005));
    const Outcome two = performed("drop", {{"heights", "2"}, {"bounces", "2"}, {"density_kg_m3", "50"}});
    CHECK(two.sheet.fact("worst_restitution") < 0.003);
    REQUIRE(two.recordings.size() == 3);
    CHECK(two.recordings[0].name == "drop-200mm");
    CHECK(two.recordings[2].rows.size() == 4);
    // The record begins at the height of release and at rest, a row a millisecond.
    CHECK(two.recordings[1].rows[0][1] == about(0.8));
    CHECK(two.recordings[1].rows[0][2] == 0);
    CHECK(two.recordings[1].rows[100][1] == about(0.8 - 9.81 / 2 * 0.01, 0.001));
}

TEST_CASE("air takes what the closed form says, much from a light ball, and one height would call it restitution") {
    const Outcome outcome =
        performed("drop", {{"heights", "2"}, {"bounces", "1"}, {"density_kg_m3", "30"}, {"air_density_kg_m3", "1.2"}});
    CHECK(outcome.sheet.fact("worst_height") < 0.01);
    CHECK(outcome.sheet.fact("worst_restitution") > 0.02);
}

TEST_CASE("where an oblique impact slides, friction takes what Coulomb says, whatever the angle") {
    const Outcome outcome = performed("oblique", {{"angles", "3"}, {"lowest_deg", "60"}, {"restitution", "0.98"}});
    CHECK(outcome.sheet.fact("worst_sliding") < 0.002);
    REQUIRE(outcome.recordings[0].rows.size() == 3);
    for (const auto& row : outcome.recordings[0].rows)
        CHECK(row[1] == about(0.98, 0.002));
}

TEST_CASE("a ball on a plate lies still below one g, lands once a cycle at 2.5 g and every second cycle at 5 g") {
    const auto landings = [](const char* gamma) {
        return performed("plate", {{"gammas", "1"}, {"lowest", gamma}, {"restitution", "0.03"}})
            .recordings.back()
            .rows[0][1];
    };
    CHECK(landings("0.9") == 0);
    CHECK(landings("2.5") == about(1, 0.06));
    CHECK(landings("5") == about(0.5, 0.06));
}

TEST_CASE("the block that never rebounds lands once a cycle to 3.72, alternates to 4.6, and skips a cycle to 6.4") {
    // Computed beside by another program: one length of 1.00 periods at 3.6, 0.59 and 1.22 at 4.4, 1.79 at 5.2.
    const Outcome outcome = performed("plate", {{"gammas", "3"}, {"lowest", "3.6"}, {"highest", "5.2"}});
    CHECK(outcome.sheet.fact("block_3.60") == about(1, 0.06));
    CHECK(outcome.sheet.fact("block_4.40") == about(1, 0.06));
    CHECK(outcome.sheet.fact("block_5.20") == about(0.5, 0.06));
    for (const sheet::Part& part : outcome.sheet.parts)
        if (const auto* grid = std::get_if<sheet::Grid>(&part)) {
            CHECK(std::get<std::string>(grid->rows[1][4]) == "0.59 1.22");
            CHECK(std::get<std::string>(grid->rows[2][4]) == "1.79");
        }
}

} // namespace test_falls
