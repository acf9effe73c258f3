#include "sim3d/sandbox.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;

namespace {

struct Peak {
    double force = 0;    // N
    double overlap = 0;  // m
    double duration = 0; // s
};

/// Steps until the contact has come and gone; force is taken from the change of velocity of body 0 along x or y.
Peak impact(Sandbox& box, double mass, int axis, double reduced_share) {
    Peak peak;
    const double dt = box.scene.time_step;
    double before = box.body_now(0).velocity[axis];
    int steps_in_contact = 0;
    for (int step = 0; step < 400000; ++step) {
        box.run(1);
        const double now = box.body_now(0).velocity[axis];
        const Books books = books_of(*box.world);
        peak.overlap = std::max(peak.overlap, books.overlap_max);
        steps_in_contact += books.contacts > 0;
        if (steps_in_contact > 0 && books.contacts == 0)
            break;
        peak.force = std::max(peak.force, std::abs(now - before) / dt * mass);
        before = now;
    }
    (void)reduced_share;
    peak.duration = steps_in_contact * dt;
    return peak;
}

struct Hertz {
    double overlap, force, duration;
};

/// d = (15 m v^2 / (16 E sqrt R))^(2/5), F = 4/3 E sqrt R d^1.5, T = 2.9433 d / v (Johnson 1985, section 11.4).
Hertz theory(double E_eff, double radius, double mass, double speed) {
    const double d = std::pow(15 * mass * speed * speed / (16 * E_eff * std::sqrt(radius)), 0.4);
    return {d, 4.0 / 3.0 * E_eff * std::sqrt(radius) * std::pow(d, 1.5), 2.9433 * d / speed};
}

} // namespace

TEST_CASE("two glass spheres meet as Hertz says: Chung and Ooi test 1") {
    const contact::Material glass{"glass", 2800, 48e9, 0.20};
    Sandbox box(glass, {1.0, 0.35}, 1e-8);
    const double r = 0.010;
    const int ball = box.ball(r);
    box.start({placed(ball, {-r - 1e-7, 0, 0}, {10, 0, 0}), placed(ball, {r + 1e-7, 0, 0}, {-10, 0, 0})});
    const double mass = 4.0 / 3.0 * std::numbers::pi * r * r * r * glass.density;
    const Hertz predicted = theory(glass.youngs_modulus / (2 * (1 - 0.04)), r / 2, mass / 2, 20);
    CHECK(predicted.force == doctest::Approx(10696.9).epsilon(1e-4));
    const Peak seen = impact(box, mass, 0, 0.5);
    CHECK(seen.force == doctest::Approx(predicted.force).epsilon(1e-3));
    CHECK(seen.overlap == doctest::Approx(0.274113e-3).epsilon(1e-3));
    CHECK(seen.duration == doctest::Approx(40.34e-6).epsilon(1e-3));
    CHECK(box.body_now(0).velocity.x() == doctest::Approx(-10).epsilon(1e-6));
}
