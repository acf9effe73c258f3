// Restitution that falls with the speed of impact, and friction that weakens with the speed of sliding.
#include "about.h"
#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <cmath>
#include <string>

namespace test_speed_dependence {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double r = 2.5e-3;
const contact::Material alumina{"alumina", 4000, 3.8e9, 0.23};

contact::PairProperties falling(double e, double speed, double exponent) {
    contact::PairProperties pair;
    pair.restitution = e;
    pair.restitution_exponent = exponent;
    pair.restitution_speed = speed;
    pair.normal_stiffness = 1e6;
    pair.tangential_stiffness = 1e6;
    return pair;
}

/// Speed after over speed before a ball strikes a plane.
double rebound(const contact::PairProperties& pair, scene::NormalLaw law, double speed) {
    Sandbox box(alumina, pair, 2e-8);
    box.scene.contact.normal = law;
    box.scene.contact.tangential = scene::TangentialLaw::none;
    box.wall(scene::PlaneShape{});
    box.start({placed(box.ball(r), {0, r + 1e-9, 0}, {0, -speed, 0})});
    do
        box.run(200);
    while (books_of(*box.world).contacts > 0 || box.body_now(0).velocity.y() < 0);
    CHECK(std::abs(books_of(*box.world).closure) < 1e-3 * books_of(*box.world).inserted);
    return box.body_now(0).velocity.y() / speed;
}

} // namespace

TEST_CASE("restitution falls over a decade and a half of impact speeds with the power asked for, by both normal laws") {
    for (const auto law : {scene::NormalLaw::hertz, scene::NormalLaw::linear})
        for (const double p : {0.25, 0.2}) {
            CAPTURE(static_cast<int>(law));
            CAPTURE(p);
            const contact::PairProperties pair = falling(0.5, 1, p);
            for (const double v : {0.1, 0.3, 1.0, 3.0}) {
                CAPTURE(v);
                CHECK(rebound(pair, law, v) == about(0.5 * std::pow(v, -p), 0.01));
            }
            const double slope = std::log(rebound(pair, law, 3.0) / rebound(pair, law, 0.1)) / std::log(3.0 / 0.1);
            CHECK(slope == about(-p, 0.02));
        }
}

TEST_CASE("in slow impacts restitution is at most what the pair allows") {
    contact::PairProperties pair = falling(0.5, 1, 0.25);
    pair.restitution_most = 0.7;
    CHECK(rebound(pair, scene::NormalLaw::hertz, 0.1) == about(0.7, 0.01));
}

TEST_CASE("surfaces that stick rebound with e sqrt(1 - (v_s / v)^2), by both normal laws, and below v_s not at all") {
    contact::PairProperties pair = falling(0.6, 0, 0);
    pair.sticking_speed = 0.2;
    for (const auto law : {scene::NormalLaw::hertz, scene::NormalLaw::linear})
        for (const double v : {0.22, 0.25, 0.4, 1.0, 3.0}) {
            CAPTURE(v);
            CHECK(rebound(pair, law, v) == about(0.6 * std::sqrt(1 - 0.04 / (v * v)), 0.01));
        }
    Sandbox box(alumina, pair, 2e-8);
    box.scene.gravity = {0, -9.81, 0};
    box.wall(scene::PlaneShape{});
    box.start({placed(box.ball(r), {0, r + 1e-9, 0}, {0, -0.15, 0})});
    for (int k = 0; k < 50; ++k) { // 2 ms, twenty times as long as an impact
        box.run(2000);
        CHECK(box.body_now(0).position.y() < r + 1e-9);
    }
    CHECK(books_of(*box.world).contacts == 1);
    CHECK(std::abs(box.body_now(0).velocity.y()) < 1e-3 * 0.15);
}

TEST_CASE("each impact has its own speed: a ball that bounces loses less and less of it") {
    const double p = 0.25, e = 0.5, g = 30; // m/s2, so that flights are short; g T_c is 0.1 % of the speed
    Sandbox box(alumina, falling(e, 1, p), 1e-7);
    box.scene.gravity = {0, -g, 0};
    box.wall(scene::PlaneShape{});
    box.start({placed(box.ball(r), {0, r + 1e-9, 0}, {0, -1, 0})});
    double expected = 1;
    for (int bounce = 0; bounce < 3; ++bounce) {
        expected *= e * std::pow(expected, -p);
        do
            box.run(100);
        while (books_of(*box.world).contacts > 0 || box.body_now(0).velocity.y() < 0);
        const double height = box.body_now(0).position.y() - r;
        const double speed = std::sqrt(std::pow(box.body_now(0).velocity.y(), 2) + 2 * g * height);
        CHECK(speed == about(expected, 0.01));
        while (box.body_now(0).velocity.y() > 0)
            box.run(1000);
    }
}

TEST_CASE("a block that slides under weakening friction slows down as the closed form says") {
    // v' = -g (mu_k + (mu_s - mu_k) exp(-v / v_c)); u = exp(v / v_c) turns it into u' = -g / v_c (mu_k u + mu_s -
    // mu_k).
    const double g = 9.81, mu_s = 0.5, mu_k = 0.2, v_c = 0.1, v_0 = 0.4;
    contact::PairProperties pair;
    pair.restitution = 0.5;
    pair.friction = mu_s;
    pair.sliding_friction = mu_k;
    pair.sliding_speed = v_c;
    Sandbox box({"stone", 2500, 5e7, 0.25}, pair, 1e-5);
    box.scene.gravity = {0, -g, 0};
    box.wall(scene::PlaneShape{});
    const double a = 5e-3, R = 3e-3;
    const int block = box.body({{{-a, 0, -a}, R}, {{a, 0, -a}, R}, {{-a, 0, a}, R}, {{a, 0, a}, R}});
    box.start({placed(block, {0, R, 0}, {v_0, 0, 0})});
    const double ratio = (mu_s - mu_k) / mu_k;
    for (const double time : {0.03, 0.06, 0.09}) {
        box.run(std::llround(time / 1e-5) - steps_of(*box.world));
        const double u = (std::exp(v_0 / v_c) + ratio) * std::exp(-g * mu_k * time / v_c) - ratio;
        CHECK(box.body_now(0).velocity.x() == about(v_c * std::log(u), 0.02));
    }
    CHECK(std::abs(books_of(*box.world).closure) < 2e-3 * books_of(*box.world).lost_sliding);
}

TEST_CASE("what does not fall changes no bit: a power of 0 is the plain law, and so is mu_k = mu_s") {
    const auto fate = [](const contact::PairProperties& pair) {
        Sandbox box({"glass", 2500, 5e7, 0.25}, pair, 1e-5);
        box.scene.gravity = {0.5, -9.81, 0};
        box.wall(scene::PlaneShape{});
        const int ball = box.ball(0.01);
        box.start({placed(ball, {0, 0.02, 0}, {1, 0, 0}), placed(ball, {0.002, 0.05, 0})});
        CHECK(!box.world->remembers_more);
        box.run(10000);
        return box.body_now(0);
    };
    contact::PairProperties plain;
    plain.restitution = 0.6;
    plain.friction = 0.4;
    contact::PairProperties same = plain;
    same.restitution_speed = 1;
    same.restitution_exponent = 0;
    same.sliding_friction = 0.4;
    same.sliding_speed = 0.1;
    CHECK(fate(plain).position == fate(same).position);
    CHECK(fate(plain).angular_velocity == fate(same).angular_velocity);
}

} // namespace test_speed_dependence
