#include "about.h"
#include "base/rng.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_conservation {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

struct Motion {
    Vector2d momentum = Vector2d::Zero(); // kg m/s
    double turning = 0;                   // kg m2/s, about the origin
    double size = 0;                      // kg m2/s, the parts of `turning` without their signs
};

Motion motion_of(const World& world) {
    Motion all;
    for (const BodyState& body : bodies_of(world)) {
        const BodyShape& shape = shapes_of(world)[static_cast<std::size_t>(body.shape)];
        const Vector2d p = shape.mass * body.velocity;
        const double orbit = body.position.x() * p.y() - body.position.y() * p.x();
        all.momentum += p;
        all.turning += orbit + shape.inertia * body.angular_velocity;
        all.size += std::abs(orbit) + shape.inertia * std::abs(body.angular_velocity);
    }
    return all;
}

} // namespace

TEST_CASE("momentum and angular momentum of a crowd that rubs, damps and overlaps are kept to rounding") {
    // Soft and slow enough for overlaps of some percent: shear at the discs' radii in place of the middle of the
    // overlap would show in the first figures.
    Sandbox box(springs(2e5, 0.7, 0.6, 0.5), 2e-4);
    const int disc = box.disc(0.08),
              clump = box.body({{{0, 0, 0}, 0.06}, {{0.09, 0.02, 0}, 0.05}, {{0.2, 0, 0}, 0.04}});
    Rng rng(11);
    std::vector<BodyState> bodies;
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y) {
            const Vector2d place(0.35 * x, 0.35 * y);
            const Vector2d noise(rng.uniform(-1, 1), rng.uniform(-1, 1));
            bodies.push_back(at((x + y) % 2 == 0 ? disc : clump, place, -2 * place + noise + Vector2d(0.5, -0.2),
                                rng.uniform(-20, 20)));
        }
    box.put(bodies);
    const Motion before = motion_of(*box.world);
    box.step(30000); // until all have flown apart again, so that velocities and places are of one instant
    const Motion after = motion_of(*box.world);
    const Books books = books_of(*box.world);
    REQUIRE(books.contacts == 0);
    CHECK(books.lost_sliding > 0.02 * books.inserted);
    CHECK(books.overlap_ratio_peak > 0.03);
    CHECK((after.momentum - before.momentum).norm() < 1e-12 * before.size);
    CHECK(std::abs(after.turning - before.turning) < 1e-12 * before.size);
}

TEST_CASE("the error of the energy balance in an impact that swings along and across falls with the step squared") {
    // Begins at the very touch, so that each step length meets the same kink; no dashpot, friction that never gives.
    const double k = 1e5, mass = 1000 * pi * 0.01;
    const double contact_time = pi * std::sqrt(mass / k);
    const auto missed = [&](int steps) {
        Sandbox box(springs(k, 0.3, 1, 100), contact_time / steps);
        box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
        box.put({at(box.disc(0.1), {0, 0.1}, {0.1, -0.3}, 2)});
        double worst = 0;
        for (int n = 0; n < steps * 9 / 10; ++n) {
            box.step();
            worst = std::max(worst, std::abs(books_of(*box.world).closure));
        }
        return worst / books_of(*box.world).inserted;
    };
    const double coarse = missed(50), middle = missed(100), fine = missed(200);
    CHECK(coarse < 2e-3);
    CHECK(coarse / middle > 3.8);
    CHECK(middle / fine > 3.8);
}

TEST_CASE("a wall that strikes a resting disc does 2 m v^2 of work, and the disc flies off with 2 v") {
    const double v = 0.4, k = 1e6;
    Sandbox box(springs(k, 1, 1, 0), 2e-5);
    box.wall(scene::SegmentShape{{-1, -1}, {-1, 1}}).motion.linears = {{{}, {v, 0, 0}}};
    const int disc = box.disc(0.1);
    box.put({at(disc, {-0.88, 0})});
    box.step(5000); // 0.05 s to the touch, 0.02 s of it
    const double mass = box.shape(disc).mass;
    CHECK(box.body_at(0).velocity.x() == about(2 * v, 1e-4));
    CHECK(books_of(*box.world).wall_work == about(2 * mass * v * v, 1e-4));
}

TEST_CASE("a belt that sets a disc rolling does m v^2 / 3 of work, half of which is lost to sliding and its dashpot") {
    // Friction brings the disc to v / 3 and its rim to 2 v / 3 against it: m v^2 / 6 of motion. The belt's force,
    // momentum per time, goes at v all the while: m v / 3 times v. All that up to the overlap over R, 0.3 percent. The
    // dashpot's share is what it takes before the spring bears its limit.
    const double v = 0.5, g = 9.81, k = 1e6, mu = 0.3;
    Sandbox box(springs(k, 1, 0.3, mu), 2e-5);
    box.scene.gravity = {0, -g, 0};
    box.wall(scene::SegmentShape{{-40, 0}, {40, 0}}).motion.linears = {{{}, {v, 0, 0}}};
    const int disc = box.disc(0.1);
    box.build();
    const double mass = box.shape(disc).mass;
    box.put({at(disc, {0, 0.1 - mass * g / k})});
    box.step(std::llround(1.5 * v / (3 * mu * g) / 2e-5));
    const Books books = books_of(*box.world);
    CHECK(box.body_at(0).velocity.x() == about(v / 3, 3e-3));
    CHECK(books.wall_work == about(mass * v * v / 3, 3e-3));
    CHECK(books.lost_sliding + books.lost_tangential_damping == about(mass * v * v / 6, 5e-3));
}

TEST_CASE("a normal force that may not pull ends a rebound sooner: restitution as Schwager and Poeschel have it") {
    // 2007, Granular Matter 9, 465: the contact ends when the force is zero, before the overlap is.
    for (const double e : {0.3, 0.6}) {
        CAPTURE(e);
        Sandbox box(springs(1e5, 1, e, 0), 1e-5);
        box.scene.contact.limit_force = true;
        box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
        box.put({at(box.disc(0.1), {0, 0.1}, {0, -0.5})});
        box.step(10000); // twice the contact time and more
        const double zeta = -std::log(e) / std::hypot(std::log(e), pi), root = std::sqrt(1 - zeta * zeta);
        const double angle = pi - std::atan2(2 * zeta * root, 1 - 2 * zeta * zeta);
        CHECK(box.body_at(0).velocity.y() == about(0.5 * std::exp(-zeta / root * angle), 2e-3));
    }
}

} // namespace test_conservation
