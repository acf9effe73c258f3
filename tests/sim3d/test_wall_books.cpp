#include "about.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_wall_books {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

struct Shaken {
    double lost;   // J, to the dashpots in 20 periods
    double missed; // J, by the books in these
    double driven; // J, what theory says the dashpots take
};

/// A ball that rests on a floor, spring and dashpot without slip, shaken at its resonance along x or y. The distance s
/// that the surfaces go against each other follows M s'' + c s' + k s = -M y'' for y = A sin(w t), where M is the mass
/// that the contact moves: m along the normal, m / 3.5 along the floor, as the ball also turns. At w^2 = k / M that is
/// |s| = M A w / c, and a period takes pi c w |s|^2.
Shaken shake(int axis, int steps_per_period) {
    const double r = 5e-3, mass = 2500 * 4.0 / 3 * pi * r * r * r, share = 0.2, omega = 2 * pi * 200, g = 9.81;
    const double moved = axis == 1 ? mass : mass / 3.5;
    const double stiffness = moved * omega * omega;
    const double restitution = std::exp(-pi * share / std::sqrt(1 - share * share));
    const double normal = axis == 1 ? stiffness : 50 * stiffness;
    Sandbox box({"glass", 2500, 1e9, 0.2}, {restitution, 100, normal, stiffness}, 2 * pi / omega / steps_per_period);
    box.scene.contact.normal = scene::NormalLaw::linear;
    box.scene.contact.tangential = scene::TangentialLaw::linear;
    box.scene.gravity = {0, -g, 0};
    const double amplitude = 0.15 * g / (omega * omega); // leaves the ball on the floor
    box.wall(scene::PlaneShape{}).motion.harmonics = {{{}, axis, amplitude, 200, 0}};
    box.start({placed(box.ball(r), {0, r - mass * g / normal, 0})});
    box.run(20 * steps_per_period); // until how it began is forgotten
    const Books before = books_of(*box.world);
    box.run(20 * steps_per_period);
    const Books after = books_of(*box.world);
    CHECK(after.contacts == 1);
    CHECK(after.lost_sliding == 0);
    const auto lost = [](const Books& books) { return books.lost_normal_damping + books.lost_tangential_damping; };
    const double c = 2 * share * std::sqrt(stiffness * mass), swing = moved * amplitude * omega / c;
    return {lost(after) - lost(before), std::abs(after.closure - before.closure), 20 * pi * c * omega * swing * swing};
}

} // namespace

TEST_CASE("the books of a ball on a shaken floor close to second order in the step, along the normal and across") {
    for (const int axis : {1, 0}) {
        CAPTURE(axis);
        const Shaken coarse = shake(axis, 40), fine = shake(axis, 160);
        // The swing itself is off by (w dt)^2 = 1.5e-3 of its square at most.
        CHECK(fine.lost == about(fine.driven, 2e-3));
        CHECK(coarse.missed < 0.01 * coarse.lost);
        CHECK(coarse.missed > 12 * fine.missed);
    }
}

} // namespace test_wall_books
