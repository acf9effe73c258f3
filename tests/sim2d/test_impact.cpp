#include "about.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_impact {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

/// Two equal discs meet head-on: what the spring and the dashpot between them do.
struct HeadOn {
    double overlap = 0, force = 0, duration = 0, restitution = 0;

    HeadOn(const contact::PairProperties& pair, double speed, double dt) {
        Sandbox box(pair, dt);
        const int disc = box.disc(0.1);
        box.put({at(disc, {0, 0}, {speed / 2, 0}), at(disc, {0.2, 0}, {-speed / 2, 0})});
        const double mass = box.shape(disc).mass;
        double before = speed / 2;
        for (int k = 0; k < 100000; ++k) {
            box.step();
            const BodyState left = box.body_at(0), right = box.body_at(1);
            const double depth = 0.2 - (right.position.x() - left.position.x());
            overlap = std::max(overlap, depth);
            force = std::max(force, mass * (before - left.velocity.x()) / dt);
            before = left.velocity.x();
            if (depth > 0)
                duration = time_of(*box.world);
            else if (k > 10)
                break;
        }
        restitution = (box.body_at(1).velocity.x() - box.body_at(0).velocity.x()) / speed;
    }
};

} // namespace

TEST_CASE("a head-on impact is half a swing of the damped oscillator: overlap, force, duration") {
    const double speed = 0.5, k = 1e5;
    const double mass = 1000 * pi * 0.01 / 2; // kg, m* of two discs of radius 0.1 m
    const double w = std::sqrt(k / mass);
    for (const double e : {1.0, 0.9, 0.7}) {
        CAPTURE(e);
        const double zeta = -std::log(e) / std::hypot(std::log(e), pi);
        const double damped = w * std::sqrt(1 - zeta * zeta);
        const double duration = pi / damped;
        const HeadOn hit(springs(k, 1, e, 0), speed, duration / 4000);
        // n(t) = v / w_d exp(-zeta w t) sin(w_d t); k n + c n' is largest where its rate is zero.
        const double deepest = std::atan2(std::sqrt(1 - zeta * zeta), zeta) / damped;
        const double overlap = speed / w * std::exp(-zeta * w * deepest);
        CHECK(hit.overlap == about(overlap, 1e-3));
        CHECK(hit.duration == about(duration, 2e-3));
        const double strongest =
            std::atan2((1 - 4 * zeta * zeta) * std::sqrt(1 - zeta * zeta), zeta * (3 - 4 * zeta * zeta)) / damped;
        const double n = speed / damped * std::exp(-zeta * w * strongest) * std::sin(damped * strongest);
        const double rate = speed * std::exp(-zeta * w * strongest) *
                            (std::cos(damped * strongest) - zeta * w / damped * std::sin(damped * strongest));
        CHECK(hit.force == about(k * n + 2 * zeta * w * mass * rate, 2e-3));
    }
}

TEST_CASE("restitution comes out as it was put in") {
    for (const double e : {0.1, 0.3, 0.5, 0.8, 1.0}) {
        CAPTURE(e);
        CHECK(HeadOn(springs(1e5, 1, e, 0), 0.5, 1e-5).restitution == about(e, 5e-3));
    }
}

TEST_CASE("a given contact time is how long an impact lasts, whatever the masses") {
    contact::PairProperties pair;
    pair.restitution = 0.6;
    pair.contact_time = 0.02;
    pair.stiffness_ratio = 1;
    const HeadOn hit(pair, 0.5, 1e-5);
    CHECK(hit.duration == about(0.02, 2e-3));
    CHECK(hit.restitution == about(0.6, 5e-3));
}

TEST_CASE("stiffness-proportional damping is beta k: restitution follows from the damping ratio beta w / 2") {
    contact::PairProperties pair = springs(1e5, 1, 1, 0);
    pair.damping_time = 2e-3;
    const double mass = 1000 * pi * 0.01 / 2;
    const double zeta = 0.5 * pair.damping_time * std::sqrt(1e5 / mass);
    const double e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
    CHECK(HeadOn(pair, 0.5, 1e-5).restitution == about(e, 5e-3));
}

TEST_CASE("global damping lets a free disc's velocity and spin die away as exp(-alpha t)") {
    Sandbox box(springs(1e5, 1, 1, 0), 1e-3);
    box.scene.contact.global_damping = 2;
    const int disc = box.disc(0.1);
    box.put({at(disc, {0, 0}, {3, -1}, 7)});
    box.step(1000);
    const double left = std::exp(-2.0);
    CHECK(box.body_at(0).velocity.x() == about(3 * left, 1e-5));
    CHECK(box.body_at(0).velocity.y() == about(-left, 1e-5));
    CHECK(box.body_at(0).angular_velocity == about(7 * left, 1e-5));
    CHECK(std::abs(books_of(*box.world).closure) < 1e-5 * books_of(*box.world).inserted);
}

TEST_CASE("before the first step the books hold the bodies with the energy that they brought, and close") {
    Sandbox box({}, 1e-4);
    box.scene.gravity = {0, -9.81, 0};
    const int disc = box.disc(0.1);
    box.put({at(disc, {0, 0.5}, {3, 4}, 20), at(disc, {1, -2})});
    const double mass = box.shape(disc).mass;
    const Books books = books_of(*box.world);
    CHECK(books.bodies == 2);
    CHECK(books.kinetic_translation == about(0.5 * mass * 25));
    CHECK(books.kinetic_rotation == about(0.5 * 0.5 * mass * 0.01 * 400));
    CHECK(books.gravity == about(mass * 9.81 * (0.5 - 2)));
    CHECK(std::abs(books.closure) < 1e-14 * books.kinetic_translation);
}

} // namespace test_impact
