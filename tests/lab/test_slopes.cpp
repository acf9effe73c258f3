#include "about.h"
#include "performed.h"

#include <cmath>

namespace test_slopes {

using namespace tumble;
using namespace tumble::lab;
using namespace tumble::lab::testing;
using tumble::test::about;

TEST_CASE("the tangent of the angle at which a body slides is its friction, both ways") {
    const Outcome outcome = performed("slide", {{"frictions", "2"}, {"lowest", "0.2"}, {"highest", "0.7"}});
    CHECK(outcome.sheet.fact("worst_friction") < 0.005);
    CHECK(std::abs(outcome.sheet.fact("bench_tilt")) < 0.05);
    CHECK(outcome.recordings.size() == 5);
}

TEST_CASE("a bench that is off level shows as half the difference of the two ways, and friction stays right") {
    const Outcome outcome = performed("slide", {{"frictions", "1"}, {"lowest", "0.4"}, {"bench_tilt_deg", "3"}});
    CHECK(outcome.sheet.fact("worst_friction") < 0.005);
    CHECK(std::abs(outcome.sheet.fact("bench_tilt")) == about(3, 0.03));
}

TEST_CASE("a ball rolls down with 5/7 g sin(slope) and slips beyond tan(slope) = 7/2 friction") {
    const Outcome outcome = performed("roll", {{"angles", "3"}, {"lowest_deg", "10"}, {"highest_deg", "50"}});
    CHECK(outcome.sheet.fact("worst_acceleration") < 0.002);
    const Outcome tilted = performed("roll", {{"angles", "1"}, {"lowest_deg", "20"}, {"bench_tilt_deg", "1"}});
    CHECK(std::abs(tilted.sheet.fact("bench_tilt")) == about(1, 0.02));
}

TEST_CASE("a ball that rolls out gives its rolling resistance, and a bench that is off level apart from it") {
    const Outcome outcome = performed("roll-out", {{"bench_tilt_deg", "0.2"}});
    CHECK(outcome.sheet.fact("rolling_friction") / 0.02 == about(1, 0.01));
    CHECK(std::abs(outcome.sheet.fact("bench_tilt")) / 0.2 == about(1, 0.02));
    CHECK(outcome.sheet.fact("dry_is_best") == 1);
}

TEST_CASE("dry friction slows a spinning tripod at a constant rate, and the record says so") {
    const Outcome outcome = performed("spin-down");
    CHECK(outcome.sheet.fact("slowing") == about(outcome.sheet.fact("slowing_theory"), 0.01));
    CHECK(outcome.sheet.fact("friction") == about(0.3, 0.01));
    CHECK(outcome.sheet.fact("dry_is_best") == 1);
}

TEST_CASE("friction is what holds a heap of triangles") {
    const auto angle = [](const char* friction) {
        return performed("repose", {{"seeds", "2"}, {"count", "150"}, {"friction", friction}})
            .sheet.fact("angle_triangles");
    };
    // Without friction each contact slides: what is left has no slope but that of its few layers.
    CHECK(angle("0.5") > angle("0") + 5);
}

} // namespace test_slopes
