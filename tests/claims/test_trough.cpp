#include "about.h"
#include "claims.h"
#include "sim3d/solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_trough {

using namespace tumble;
using namespace tumble::test;

TEST_CASE("trough-quick: a trough that moves round a circle makes its load circulate") {
    const Ran circle(loaded("trough-quick.toml", {"duration_s=2.0"}));
    CHECK(circle.summary.bodies == 1000);
    CHECK(circle.summary.unfilled.empty());
    for (const double from : {1.0, 1.4}) { // ten periods of the wall each
        CAPTURE(from);
        const double part = circle.mean("circulation", from, from + 0.4);
        CHECK(part > 0.35);
        CHECK(part < 0.75);
    }
    CHECK(circle.mean("circulation", 1.0, 2.0) == about(0.55, 0.15));
    CHECK(std::abs(circle.summary.books.closure) < 2e-3 * circle.summary.energy_turnover);
}

TEST_CASE("trough-quick: in phase, on a straight line, it turns the other way and less than half as fast") {
    const Ran line(loaded("trough-quick.toml", {"duration_s=1.8", "wall.0.motion.1.phase_deg=0"}));
    for (const double from : {1.0, 1.4}) {
        CAPTURE(from);
        const double part = line.mean("circulation", from, from + 0.4);
        CHECK(part > -0.4);
        CHECK(part < -0.1);
    }
    CHECK(line.mean("circulation", 1.0, 1.8) == about(-0.22, 0.25));
}

TEST_CASE("trough-slice: the load and the drive are the thesis'") {
    const scene::Scene slice = loaded("trough-slice.toml");
    const auto world = sim3d::build_world(slice, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    const double cone = sim3d::shapes_of(**world).front().mass;
    // Table 5.2 weighs 4878 cones at 22.892 kg, with LIGGGHTS' sampling error in each (docs/peers.md).
    CHECK(4878 * cone == about(22.892, 0.005));
    CHECK(slice.time_step == about(1.0 / 350000, 1e-12));
    // Figure 5.21's strongest harmonic, 1.949 mm at 25 Hz, is a peak of 4.9 g upwards.
    double strongest = 0;
    for (const scene::Harmonic& harmonic : slice.walls.front().motion.harmonics)
        if (harmonic.axis == 1)
            strongest =
                std::max(strongest, harmonic.amplitude * std::pow(2 * std::numbers::pi * harmonic.frequency, 2));
    CHECK(strongest / 9.81 == about(4.9, 0.02));
}

TEST_CASE("trough-3d: spheres and cones weigh what the thesis' load does, and are shaken as it was, in phase") {
    for (const char* name : {"measured/trough-3d/spheres.toml", "measured/trough-3d/cones.toml"}) {
        CAPTURE(name);
        const scene::Scene scene = loaded(name);
        const auto world = sim3d::build_world(scene, 1);
        REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
        const double body = sim3d::shapes_of(**world).front().mass;
        const double length = scene.domain.box.hi[0] - scene.domain.box.lo[0];
        CHECK(static_cast<double>(scene.fills.front().count.value()) * body / length == about(22.892 / 0.1, 0.005));
        const auto& parts = scene.walls.front().motion.harmonics;
        REQUIRE(parts.size() == 2);
        CHECK(parts[0].amplitude == about(0.001949, 1e-9));
        CHECK(parts[1].amplitude == about(0.0004038, 1e-9));
        CHECK(parts[0].phase == parts[1].phase);
    }
}

TEST_CASE("trough-3d: a quarter load of spheres turns to the side that the phase decides, and slopes with it") {
    const std::vector<std::string> quarter{"fill.0.count=610", "duration_s=2.2",
                                           "wall.0.motion.1.amplitude_m=0.001949"};
    const auto shaken = [&](const char* phase) {
        std::vector<std::string> sets = quarter;
        sets.push_back(std::string("wall.0.motion.1.phase_deg=") + phase);
        return Ran(loaded("measured/trough-3d/spheres.toml", sets));
    };
    const Ran in_phase = shaken("0"), ahead = shaken("90");
    CHECK(in_phase.mean("circulation", 1.4, 2.2) < -0.05);
    CHECK(in_phase.mean("surface_slope", 1.4, 2.2) > 5);
    CHECK(ahead.mean("circulation", 1.4, 2.2) > 0.15);
    CHECK(ahead.mean("surface_slope", 1.4, 2.2) < -8);
}

} // namespace test_trough
