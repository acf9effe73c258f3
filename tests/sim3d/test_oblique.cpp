#include "about.h"
#include "sim3d/sandbox.h"

#include <cmath>
#include <numbers>

namespace test_oblique {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

// Chung and Ooi (2011) test 4: aluminium oxide sphere on a rigid plane.
constexpr double radius = 2.5e-3;
constexpr double speed = 3.9;
constexpr double restitution = 0.98;
constexpr double friction = 0.092;

struct Rebound {
    double tangential = 0; // m/s
    double spin = 0;       // rad/s, in the sense that rolling has
};

/// Impact at `degrees` from the normal.
Rebound rebound(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    Sandbox box({"alumina", 4000, 380e9, 0.23}, {restitution, friction}, 2e-9);
    box.wall(scene::PlaneShape{}, box.wall_material({"rigid", 7800, 1e20, 0.3}, {restitution, friction}));
    box.start(
        {placed(box.ball(radius), {0, radius + 1e-9, 0}, {speed * std::sin(angle), -speed * std::cos(angle), 0})});
    int contact_steps = 0;
    do {
        box.run(1);
        contact_steps += books_of(*box.world).contacts > 0 ? 1 : 0;
    } while (contact_steps == 0 || books_of(*box.world).contacts > 0);
    const BodyState body = box.body_now(0);
    return {body.velocity.x(), -body.angular_velocity.z()};
}

} // namespace

TEST_CASE("an impact that slides throughout loses mu (1 + e) v_n, whatever its angle: Chung and Ooi test 4") {
    for (const double degrees : {35.0, 40.0, 50.0, 60.0, 70.0, 80.0}) {
        CAPTURE(degrees);
        const double angle = degrees * std::numbers::pi / 180;
        const double kick = friction * (1 + restitution) * speed * std::cos(angle);
        const Rebound seen = rebound(degrees);
        CHECK(seen.tangential == about(speed * std::sin(angle) - kick, 2e-3));
        CHECK(seen.spin == about(2.5 * kick / radius, 2e-3));
    }
}

TEST_CASE("the printed case at 40 degrees: e_t 0.7829 and 544.2 rad/s") {
    const Rebound seen = rebound(40);
    CHECK(seen.tangential / (speed * std::sin(40 * std::numbers::pi / 180)) == about(0.7829, 2e-3));
    CHECK(seen.spin == about(544.2, 2e-3));
}

TEST_CASE("an impact that sticks for a while rebounds as Chung and Ooi's figures show, 15 to 30 degrees") {
    struct Row {
        double degrees, ratio, spin;
    };
    for (const Row& row : {Row{15, 0.624, 378}, Row{20, 0.616, 511}, Row{25, 0.634, 599}, Row{30, 0.684, 617}}) {
        CAPTURE(row.degrees);
        const Rebound seen = rebound(row.degrees);
        CHECK(seen.tangential / (speed * std::sin(row.degrees * std::numbers::pi / 180)) == about(row.ratio, 0.03));
        CHECK(seen.spin == about(row.spin, 0.03));
    }
}

TEST_CASE("a sliding sphere rolls after 2 u0 / (7 mu g), at 5/7 of its speed") {
    for (const double mu : {0.2, 0.6, 1.0}) {
        CAPTURE(mu);
        const double u0 = 1.0;
        const double g = 9.81;
        const double r = 0.01;
        Sandbox box({"soft", 2000, 1e7, 0.3}, {0.5, mu}, 1e-5);
        box.scene.gravity = {0, -g, 0};
        box.wall(scene::PlaneShape{});
        // Placed at its static overlap, F = 4/3 E* sqrt(R) d^1.5 = m g, so that it does not bounce.
        const double mass = 4.0 / 3.0 * std::numbers::pi * r * r * r * 2000;
        const double E_eff = 1e7 / (2 * (1 - 0.09));
        const double sink = std::pow(3 * mass * g / (4 * E_eff * std::sqrt(r)), 2.0 / 3.0);
        box.start({placed(box.ball(r), {0, r - sink, 0}, {u0, 0, 0})});
        const double predicted = 2 * u0 / (7 * mu * g);
        double rolls_at = 0;
        while (rolls_at == 0) {
            box.run(1);
            const BodyState body = box.body_now(0);
            if (std::abs(body.angular_velocity.z()) * r >= body.velocity.x())
                rolls_at = time_of(*box.world);
            REQUIRE(time_of(*box.world) < 2 * predicted);
        }
        CHECK(rolls_at == about(predicted, 6e-3));
        box.run(20000);
        CHECK(box.body_now(0).velocity.x() == about(5.0 / 7.0 * u0, 6e-3));
    }
}

} // namespace test_oblique
