#include "about.h"
#include "observe/part_loads.h"

#include <cmath>
#include <doctest/doctest.h>
#include <utility>

namespace test_part_loads {

using namespace tumble::observe;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

/// On a floor: pressed with `normal` N and dragged along x with `shear` N, arriving with 2 m/s down and 1.5 m/s along.
WallPush push(std::int64_t body, double normal, double shear) {
    WallPush push;
    push.body = body;
    push.triangle = 3;
    push.normal = Vector3d::UnitY();
    push.force = Vector3d(shear, -normal, 0);
    push.velocity = Vector3d(1.5, -2, 0);
    return push;
}

} // namespace

TEST_CASE("a body's touches are told apart: first the impact, then what follows within the pause, then a new row") {
    const double dt = 1e-3;
    TouchHistory history(dt, 0.01);
    for (int step = 0; step < 40; ++step) {
        std::vector<WallPush> pushes;
        if (step < 3) // impact: 3 steps of 4 N and 1 N
            pushes.push_back(push(7, 4, 1));
        if (step == 5 || step == 6) // comes back after 3 ms, harder; two places at once count together
            pushes = {push(7, 4, 1), push(7, 2, 2)};
        if (step == 30) // away for 24 ms
            pushes.push_back(push(7, 1, 0));
        if (step == 4)
            pushes.push_back(push(8, 9, 0));
        history.take(step * dt, pushes);
    }
    const std::vector<Touching> touches = history.touches();
    REQUIRE(touches.size() == 4);
    const Touching &impact = touches[0], &other = touches[1], &sliding = touches[2], &fresh = touches[3];
    CHECK(impact.number == 1);
    CHECK(std::isnan(impact.since));
    CHECK(impact.duration == about(3 * dt, 1e-12));
    CHECK(impact.approach == about(2));
    CHECK(impact.slip == about(1.5));
    CHECK(impact.normal_impulse == about(3 * dt * 4, 1e-12));
    CHECK(impact.shear_impulse == about(3 * dt * 1, 1e-12));
    CHECK(other.body == 8);
    CHECK(sliding.number == 2);
    CHECK(sliding.since == about(3 * dt, 1e-12));
    CHECK(sliding.peak_normal == about(6));
    CHECK(sliding.peak_shear == about(3));
    CHECK(fresh.number == 1);
    CHECK(fresh.since == about(24 * dt, 1e-12));
    CHECK(fresh.triangle == 3);
}

TEST_CASE("a touch knows when it pressed hardest, and when it sheared hardest") {
    // Normal forces 2, 5, 3 and 1 N, shear forces 0.5, 0.6, 0.9 and 0.1 N, a millisecond apart from 7 ms on.
    TouchHistory history(1e-3, 0.01);
    int step = 7;
    for (const auto& [normal, shear] : std::vector<std::pair<double, double>>{{2, 0.5}, {5, 0.6}, {3, 0.9}, {1, 0.1}})
        history.take(1e-3 * step++, {push(4, normal, shear)});
    const std::vector<Touching> touches = history.touches();
    REQUIRE(touches.size() == 1);
    CHECK(touches[0].begin == about(7e-3));
    CHECK(touches[0].peak_normal_time == about(8e-3));
    CHECK(touches[0].peak_shear_time == about(9e-3));
}

} // namespace test_part_loads
