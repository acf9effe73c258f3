#include "about.h"
#include "sandbox.h"
#include "sim2d/time_step.h"

#include <cmath>
#include <numbers>

namespace test_time_step {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

/// The largest |overlap| of two discs on one spring without damping and friction, after many steps of `dt`.
double swing(double dt, double k) {
    Sandbox box(springs(k, 1, 1, 0), dt);
    const int disc = box.disc(0.1);
    // Pressed together by two walls that hold them at rest between springs of the same kind.
    box.wall(scene::SegmentShape{{-0.09, -1}, {-0.09, 1}});
    box.wall(scene::SegmentShape{{0.28, -1}, {0.28, 1}});
    box.put({at(disc, {0, 0}), at(disc, {0.19, 0}, {1e-6, 0})});
    double most = 0;
    for (int n = 0; n < 2000; ++n) {
        if (advance(*box.world, 1))
            return 1;
        most = std::max(most, std::abs(box.body_at(1).position.x() - 0.19));
    }
    return most;
}

} // namespace

TEST_CASE("without damping two discs between walls swing stably below 2 / w of their fastest mode, and not above") {
    // Three springs in a row, two equal masses: the fastest mode is the discs against each other, w^2 = 3 k / m.
    const double k = 1e5, mass = 1000 * std::numbers::pi * 0.01;
    const double critical = 2 / std::sqrt(3 * k / mass);
    CHECK(swing(0.98 * critical, k) < 0.01);
    CHECK(swing(1.03 * critical, k) > 0.01);
}

TEST_CASE("the reported limit is that of four contacts at once that share a body, rotation included") {
    Sandbox box(springs(1e5, 0.5, 1, 0.3), 1e-4);
    box.disc(0.1);
    box.build();
    const auto report = time_step_report(box.scene, shapes_of(*box.world));
    const double mass = 1000 * std::numbers::pi * 0.01;
    // 1/m + R^2/I of both sides = 2 (1 + 2) / m; omega^2 = 4 k times that; limit 2 / omega.
    CHECK(report.limit == about(2 / std::sqrt(4 * 1e5 * 6 / mass), 1e-9));
    CHECK(report.linear_period == about(std::numbers::pi * std::sqrt(mass / 2 / 1e5), 1e-9));
    CHECK(report.rayleigh == 0);
    CHECK(report.hertz == 0);
}

TEST_CASE("where only cohesion holds the shear spring its stiffness sets the limit all the same") {
    // So soft along the normal that a contact outlasts hundreds of steps: half a period of 8 s.
    contact::PairProperties pair = springs(10, 1e5, 1, 0);
    pair.cohesion = 20;
    Sandbox box(pair, 1e-4);
    const int disc = box.disc(0.1);
    box.build();
    // k_s acts with 1/m + R^2/I of both sides, as above.
    const double mass = 1000 * std::numbers::pi * 0.01;
    const auto report = time_step_report(box.scene, shapes_of(*box.world));
    CHECK(report.limit == about(2 / std::sqrt(4 * 1e6 * 6 / mass), 1e-9));
    // One such contact alone swings with w^2 = k_s 6 / m and bears twice the step, and no more.
    const auto fastest_spin = [&](double dt) {
        box.scene.time_step = dt;
        box.build();
        box.put({at(disc, {0, 0}), at(disc, {0.1999, 0}, {0, 0}, 1e-6)});
        double most = 0;
        for (int n = 0; n < 300; ++n) {
            box.step();
            most = std::max(most, std::abs(box.body_at(1).angular_velocity));
        }
        return most;
    };
    CHECK(fastest_spin(1.96 * report.limit) < 1e-4);
    CHECK(fastest_spin(2.06 * report.limit) > 1e-3);
}

TEST_CASE("hexagonal discs with k_s = k_n that all spin alike use the reported limit up to its end") {
    // Each has six contacts that slip by twice its rim's speed: I theta'' = -6 k_s (2 R theta) R, w^2 = 24 k_s / m,
    // which is 4 k (1/m + R^2/I) of two discs. So the margin of docs/bodies.md is none here, and stable is not
    // accurate.
    const double radius = 0.1, apart = 2 * radius * (1 - 1e-4), row = std::sqrt(0.75) * apart;
    const auto fastest_spin = [&](double share) {
        Sandbox box(springs(1e5, 1, 1, 1e3), 1e-4);
        box.scene.domain = {{{0, 0, -0.5}, {6 * apart, 6 * row, 0.5}}, {true, true, false}};
        const int disc = box.disc(radius);
        box.build();
        box.scene.time_step = share * time_step_report(box.scene, shapes_of(*box.world)).limit;
        box.build();
        std::vector<BodyState> bodies;
        for (int k = 0; k < 36; ++k)
            bodies.push_back(at(disc, {(k % 6 + 0.25 + 0.5 * (k / 6 % 2)) * apart, (k / 6 + 0.5) * row}, {0, 0}, 1e-6));
        box.put(bodies);
        double most = 0;
        for (int n = 0; n < 300; ++n) {
            box.step();
            most = std::max(most, std::abs(box.body_at(17).angular_velocity));
            CHECK((n > 0 || books_of(*box.world).contacts == 3 * 36));
        }
        return most;
    };
    CHECK(fastest_spin(0.97) < 1e-5);
    CHECK(fastest_spin(1.03) > 1e-3);
}

TEST_CASE("a clump's arm shortens the limit: its discs turn it as they are pushed") {
    Sandbox box(springs(1e5, 0.5, 1, 0), 1e-4);
    box.body({{{-0.3, 0, 0}, 0.1}, {{0.3, 0, 0}, 0.1}});
    box.build();
    const BodyShape& shape = box.shape(0);
    // Two discs apart: I = 2 (m/2) (R^2/2 + d^2). A push through a disc's centre has arm 0.3 at most.
    const double mass = 2 * 1000 * std::numbers::pi * 0.01, inertia = mass * (0.005 + 0.09);
    REQUIRE(shape.mass == about(mass, 1e-9));
    REQUIRE(shape.inertia == about(inertia, 1e-9));
    const auto report = time_step_report(box.scene, shapes_of(*box.world));
    const double mobility = 2 * (1 / mass + 0.09 / inertia);
    CHECK(report.limit == about(2 / std::sqrt(4 * 1e5 * mobility), 1e-9));
    // Rubbing on the rim has a radius more, in any direction.
    box.scene.pairs[0].friction = 0.3;
    const auto rubbing = time_step_report(box.scene, shapes_of(*box.world));
    const double full = 2 * (1 / mass + 0.16 / inertia);
    CHECK(rubbing.limit == about(2 / std::sqrt(4 * 1e5 * full), 1e-9));
}

TEST_CASE("a step above the limit is refused, with what to do, unless the scene insists") {
    Sandbox box(springs(1e5, 0.5, 1, 0.3), 1e-2);
    box.disc(0.1);
    CHECK(build_world(box.scene, 1).ok());
    box.scene.allow_large_step = false;
    const auto refused = build_world(box.scene, 1);
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].key == "time_step_s");
    CHECK(refused.problems()[0].fix.find("use at most") != std::string::npos);
}

} // namespace test_time_step
