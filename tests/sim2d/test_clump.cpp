#include "about.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_clump {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;

} // namespace

TEST_CASE("a disc that strikes the end of a resting clump turns it as the impulse's arm says") {
    Sandbox box(springs(1e8, 1, 1, 0), 1e-6);
    const int disc = box.disc(0.1), pair = box.body({{{-0.3, 0, 0}, 0.1}, {{0.3, 0, 0}, 0.1}});
    const double v = 0.2, arm = 0.3;
    box.put({at(disc, {arm, 0.2001}, {0, -v}), at(pair, {0, 0})});
    box.step(5000); // 0.5 ms to the touch, about 1 ms of it
    // Without friction the relative speed of the two surfaces turns round: J = 2 v / (1/m + 1/M + arm^2/I).
    const double m = box.shape(disc).mass, M = box.shape(pair).mass, I = box.shape(pair).inertia;
    const double J = 2 * v / (1 / m + 1 / M + arm * arm / I);
    CHECK(box.body_at(0).velocity.y() == about(J / m - v, 1e-3));
    CHECK(box.body_at(1).velocity.y() == about(-J / M, 1e-3));
    CHECK(box.body_at(1).angular_velocity == about(-J * arm / I, 1e-3));
    CHECK(std::abs(box.body_at(1).velocity.x()) < 1e-3 * J / M);
}

TEST_CASE("a row of n discs that lands flat is n springs and n dashpots: its damping ratio grows by sqrt n") {
    const double e = 0.8, zeta = -std::log(e) / std::hypot(std::log(e), pi);
    for (const int n : {1, 2, 3, 5}) {
        CAPTURE(n);
        Sandbox box(springs(1e6, 1, e, 0), 1e-5);
        box.wall(scene::SegmentShape{{-2, 0}, {2, 0}});
        std::vector<scene::Sphere> row;
        for (int k = 0; k < n; ++k)
            row.push_back({{0.21 * k, 0, 0}, 0.1});
        box.put({at(box.body(row), {0, 0.1}, {0, -0.5})});
        box.step(4000); // at most 18 ms of contact
        const double together = std::sqrt(n) * zeta;
        const double expected = std::exp(-pi * together / std::sqrt(1 - together * together));
        CHECK(box.body_at(0).velocity.y() == about(0.5 * expected, 3e-3));
        CHECK(std::abs(box.body_at(0).angular_velocity) < 1e-9);
        CHECK(books_of(*box.world).contacts == 0);
    }
}

TEST_CASE("a clump thrown without forces turns evenly about its centre of mass, which flies straight") {
    Sandbox box(springs(1e6, 1, 0.5, 0.3), 1e-4);
    const int clump = box.body({{{0, 0, 0}, 0.1}, {{0.15, 0, 0}, 0.05}, {{0, 0.12, 0}, 0.05}});
    box.put({at(clump, {1, 2}, {0.3, -0.4}, 5)});
    box.step(10000);
    const BodyState end = box.body_at(0);
    CHECK((end.position - Vector2d(1.3, 1.6)).norm() < 1e-12);
    CHECK(end.angle == about(5, 1e-12));
    CHECK(end.angular_velocity == about(5, 1e-14));
}

} // namespace test_clump
