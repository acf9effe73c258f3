// Restitution that falls with the speed of impact, and friction that weakens with the speed of sliding, between discs.
#include "about.h"
#include "sandbox.h"

#include <cmath>

namespace test_speed_dependence {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double radius = 0.1;

/// Speed after over speed before a disc strikes a wall.
double rebound(const contact::PairProperties& pair, double speed) {
    Sandbox box(pair, 2e-7);
    box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
    box.put({at(box.disc(radius), {0, radius + 1e-9}, {0, -speed})});
    do
        box.step(200);
    while (books_of(*box.world).contacts > 0 || box.body_at(0).velocity.y() < 0);
    CHECK(std::abs(books_of(*box.world).closure) < 1e-3 * books_of(*box.world).inserted);
    return box.body_at(0).velocity.y() / speed;
}

} // namespace

TEST_CASE("restitution of discs falls over a decade and a half of impact speeds with the power asked for") {
    for (const double p : {0.25, 0.2}) {
        contact::PairProperties pair = springs(1e8, 1, 0.5, 0);
        pair.restitution_speed = 1;
        pair.restitution_exponent = p;
        for (const double v : {0.1, 0.3, 1.0, 3.0}) {
            CAPTURE(p);
            CAPTURE(v);
            CHECK(rebound(pair, v) == about(0.5 * std::pow(v, -p), 0.01));
        }
    }
}

TEST_CASE("three discs in a row that slide under weakening friction slow down as the closed form says") {
    // v' = -g (mu_k + (mu_s - mu_k) exp(-v / v_c)); u = exp(v / v_c) turns it into u' = -g / v_c (mu_k u + mu_s -
    // mu_k).
    const double g = 9.81, mu_s = 0.5, mu_k = 0.2, v_c = 0.1, v_0 = 0.4, stiffness = 1e7;
    contact::PairProperties pair = springs(stiffness, 1, 0.5, mu_s);
    pair.sliding_friction = mu_k;
    pair.sliding_speed = v_c;
    Sandbox box(pair, 1e-5);
    box.scene.gravity = {0, -g, 0};
    box.wall(scene::SegmentShape{{-5, 0}, {5, 0}});
    const int block = box.body({{{-2 * radius, 0, 0}, radius}, {{0, 0, 0}, radius}, {{2 * radius, 0, 0}, radius}});
    box.build();
    const double sunk = box.shape(block).mass * g / (3 * stiffness);
    box.put({at(block, {0, radius - sunk}, {v_0, 0})});
    const double ratio = (mu_s - mu_k) / mu_k;
    for (const double time : {0.03, 0.06, 0.09}) {
        CAPTURE(time);
        box.step(std::llround(time / 1e-5) - steps_of(*box.world));
        const double u = (std::exp(v_0 / v_c) + ratio) * std::exp(-g * mu_k * time / v_c) - ratio;
        CHECK(box.body_at(0).velocity.x() == about(v_c * std::log(u), 0.02));
    }
    // The account of clumps' dashpots is of first order in the step (docs/theory-2d.md): the spring winds up at 0.4
    // m/s.
    CHECK(std::abs(books_of(*box.world).closure) < 1e-2 * books_of(*box.world).lost_sliding);
}

} // namespace test_speed_dependence
