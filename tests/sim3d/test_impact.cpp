#include "about.h"
#include "sim3d/sandbox.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace test_impact {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

struct Impact {
    double force = 0;    // N
    double overlap = 0;  // m
    double duration = 0; // s
};

double ball_mass(double radius, double density) {
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density;
}

/// Steps until the contact has come and gone. The force is body 0's change of velocity, so that the books are not
/// judged by themselves; the duration is interpolated at neither end, so it is good to one step.
Impact run_impact(Sandbox& box, double mass, int axis) {
    Impact seen;
    const double dt = box.scene.time_step;
    double before = box.body_now(0).velocity[axis];
    int steps = 0;
    for (;;) {
        box.run(1);
        const double now = box.body_now(0).velocity[axis];
        const Books books = books_of(*box.world);
        seen.overlap = std::max(seen.overlap, books.overlap_max);
        steps += books.contacts > 0 ? 1 : 0;
        if (steps > 0 && books.contacts == 0)
            break;
        seen.force = std::max(seen.force, std::abs(now - before) / dt * mass);
        before = now;
    }
    seen.duration = steps * dt;
    return seen;
}

/// d = (15 m v^2 / (16 E sqrt R))^(2/5), F = 4/3 E sqrt R d^1.5, T = 2.9433 d / v (Johnson 1985, section 11.4).
Impact hertz(double E_eff, double radius, double mass, double speed) {
    const double d = std::pow(15 * mass * speed * speed / (16 * E_eff * std::sqrt(radius)), 0.4);
    return {4.0 / 3.0 * E_eff * std::sqrt(radius) * std::pow(d, 1.5), d, 2.9433 * d / speed};
}

void check_equal(const Impact& seen, const Impact& predicted) {
    CHECK(seen.force == about(predicted.force, 1e-3));
    CHECK(seen.overlap == about(predicted.overlap, 1e-3));
    CHECK(seen.duration == about(predicted.duration, 1e-3));
}

} // namespace

TEST_CASE("two equal spheres meet as Hertz says: Chung and Ooi test 1") {
    struct Row {
        contact::Material material;
        Impact published;
    };
    const Row rows[] = {{{"glass", 2800, 48e9, 0.20}, {10696.9, 0.274113e-3, 40.34e-6}},
                        {{"limestone", 2500, 20e9, 0.25}, {7108.24, 0.368304e-3, 54.20e-6}}};
    for (const Row& row : rows) {
        CAPTURE(row.material.name);
        const double r = 0.010;
        const double mass = ball_mass(r, row.material.density);
        const double nu = row.material.poisson_ratio;
        const Impact predicted = hertz(row.material.youngs_modulus / (2 * (1 - nu * nu)), r / 2, mass / 2, 20);
        check_equal(predicted, row.published);

        Sandbox box(row.material, {1.0, 0.35}, 1e-8);
        const int ball = box.ball(r);
        box.start({placed(ball, {-r - 1e-7, 0, 0}, {10, 0, 0}), placed(ball, {r + 1e-7, 0, 0}, {-10, 0, 0})});
        check_equal(run_impact(box, mass, 0), predicted);
        CHECK(box.body_now(0).velocity.x() == about(-10, 1e-6));
    }
}

TEST_CASE("fifty steps per contact see the largest overlap of Chung and Ooi test 1 to 0.1 %") {
    // At worst the peak lies between two steps: 1.25 (2.943 / 100)^2 / 2 = 0.054 % of the overlap.
    const double r = 0.010, mass = ball_mass(r, 2800);
    const Impact predicted = hertz(48e9 / (2 * (1 - 0.04)), r / 2, mass / 2, 20);
    for (const double phase : {0.0, 0.25, 0.5, 0.75}) {
        Sandbox box({"glass", 2800, 48e9, 0.20}, {1.0, 0.35}, predicted.duration / 50);
        const double apart = (0.5 + phase) * 10 * box.scene.time_step;
        const int ball = box.ball(r);
        box.start({placed(ball, {-r - apart, 0, 0}, {10, 0, 0}), placed(ball, {r + apart, 0, 0}, {-10, 0, 0})});
        const Impact seen = run_impact(box, mass, 0);
        CHECK(seen.overlap == about(predicted.overlap, 1e-3));
    }
}

TEST_CASE("a sphere meets a rigid plane as Hertz says: Chung and Ooi test 2") {
    struct Row {
        contact::Material material;
        Impact published;
    };
    const Row rows[] = {{{"aluminium alloy", 2699, 70e9, 0.30}, {11369.9, 49.717e-6, 731.7e-6}},
                        {{"magnesium alloy", 1800, 40e9, 0.35}, {7232.68, 52.123e-6, 767.1e-6}}};
    for (const Row& row : rows) {
        CAPTURE(row.material.name);
        const double r = 0.1;
        const double mass = ball_mass(r, row.material.density);
        const double nu = row.material.poisson_ratio;
        const Impact predicted = hertz(row.material.youngs_modulus / (1 - nu * nu), r, mass, 0.2);
        check_equal(predicted, row.published);

        Sandbox box(row.material, {1.0, 0.0}, 1e-7);
        box.wall(scene::PlaneShape{}, box.wall_material({"rigid", 7800, 1e20, 0.3}, {1.0, 0.0}));
        box.start({placed(box.ball(r), {0, r + 1e-7, 0}, {0, -0.2, 0})});
        check_equal(run_impact(box, mass, 1), predicted);
    }
}

TEST_CASE("what goes in as restitution comes out, for Hertz and for the linear law") {
    for (const bool linear : {false, true})
        for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            CAPTURE(linear);
            CAPTURE(e);
            const double r = 2.5e-3;
            Sandbox box({"alumina", 4000, 380e9, 0.23}, {e, 0.092, 1e7, 1e7}, linear ? 2e-8 : 2e-9);
            if (linear)
                box.scene.contact = {
                    scene::NormalLaw::linear, scene::TangentialLaw::linear, false, false, 0, 0, 0.05, {}};
            box.wall(scene::PlaneShape{}, box.wall_material({"rigid", 7800, 1e20, 0.3}, {e, 0.092, 1e7, 1e7}));
            box.start({placed(box.ball(r), {0, r + 1e-9, 0}, {0, -3.9, 0})});
            (void)run_impact(box, ball_mass(r, 4000), 1);
            CHECK(box.body_now(0).velocity.y() / 3.9 == about(e, 5e-3));
        }
}

TEST_CASE("a linear contact lasts half a period of its oscillator") {
    const double k = 1e6;
    const double r = 0.01;
    const double mass = ball_mass(r, 2500);
    Sandbox box({"glass", 2500, 5e10, 0.2}, {1.0, 0.0, k, k}, 1e-7);
    box.scene.contact = {scene::NormalLaw::linear, scene::TangentialLaw::none, false, false, 0, 0, 0.05, {}};
    box.wall(scene::PlaneShape{});
    box.start({placed(box.ball(r), {0, r, 0}, {0, -1, 0})});
    const Impact seen = run_impact(box, mass, 1);
    CHECK(seen.duration == about(std::numbers::pi * std::sqrt(mass / k), 1e-3));
    CHECK(seen.overlap == about(std::sqrt(mass / k), 1e-3));
}

TEST_CASE("an oblique impact of two spheres keeps linear and angular momentum") {
    Sandbox box({"glass", 2800, 48e9, 0.20}, {0.7, 0.05}, 1e-8);
    const double r = 0.010;
    const int ball = box.ball(r);
    const Vector3d apart(0, 0.6 * r, 0);
    box.start({placed(ball, {-0.955 * r, 0, 0}, {3, 1, 0.5}, {10, -20, 30}),
               placed(ball, Vector3d(0.955 * r, 0, 0) + apart, {-2, 0.2, -1}, {5, 40, -10})});
    const double mass = ball_mass(r, 2800);
    const double inertia = 0.4 * mass * r * r;
    const auto momenta = [&] {
        Vector3d linear = Vector3d::Zero();
        Vector3d angular = Vector3d::Zero();
        for (const BodyState& body : bodies_of(*box.world)) {
            linear += mass * body.velocity;
            angular += mass * body.position.cross(body.velocity) + inertia * body.angular_velocity;
        }
        return std::pair{linear, angular};
    };
    const auto [linear_before, angular_before] = momenta();
    box.run(6000);
    const auto [linear_after, angular_after] = momenta();
    CHECK(books_of(*box.world).contacts == 0);
    CHECK(books_of(*box.world).lost_sliding > 0);
    CHECK((linear_after - linear_before).norm() < 1e-12 * linear_before.norm());
    CHECK((angular_after - angular_before).norm() < 1e-12 * angular_before.norm());
}

TEST_CASE("the energy error of an elastic collision falls with the square of the step") {
    const double r = 0.010;
    const auto worst_closure = [&](double dt) {
        Sandbox box({"glass", 2800, 48e9, 0.20}, {1.0, 0.0}, dt);
        const int ball = box.ball(r);
        box.start({placed(ball, {-r - 1e-7, 0, 0}, {10, 0, 0}), placed(ball, {r + 1e-7, 0, 0}, {-10, 0, 0})});
        double worst = 0;
        for (int step = 0; step < static_cast<int>(30e-6 / dt); ++step) {
            box.run(1);
            worst = std::max(worst, std::abs(books_of(*box.world).closure));
        }
        return worst / (ball_mass(r, 2800) * 100);
    };
    const double coarse = worst_closure(2e-7);
    const double fine = worst_closure(1e-7);
    const double finest = worst_closure(0.5e-7);
    CHECK(coarse < 1e-3);
    CHECK(std::log2(coarse / fine) == about(2, 0.1));
    CHECK(std::log2(fine / finest) == about(2, 0.1));
}

TEST_CASE("the books of a damped, sliding impact close, the better the shorter the step") {
    const auto closure = [](double dt) {
        const double r = 2.5e-3;
        Sandbox box({"alumina", 4000, 3.8e9, 0.23}, {0.6, 0.3}, dt);
        box.wall(scene::PlaneShape{}, box.wall_material({"rigid", 7800, 1e20, 0.3}, {0.6, 0.3}));
        box.start({placed(box.ball(r), {0, r + 1e-8, 0}, {2, -3, 0}, {0, 0, 300})});
        box.run(static_cast<std::int64_t>(80e-6 / dt));
        const Books books = books_of(*box.world);
        CHECK(books.contacts == 0);
        CHECK(books.lost_normal_damping > 0);
        CHECK(books.lost_sliding > 0);
        return std::abs(books.closure) / books.inserted;
    };
    const double coarse = closure(4e-8);
    const double fine = closure(1e-8);
    CHECK(coarse < 2e-3);
    CHECK(fine < 0.3 * coarse);
}

TEST_CASE("without pulling forces a linear impact ends when the force does, as Schwager and Poeschel derive") {
    const double r = 5e-3;
    const double k = 1e5;
    const double mass = ball_mass(r, 2500);
    for (const double e : {0.7, 0.3}) {
        CAPTURE(e);
        const double omega0 = std::sqrt(k / mass);
        Sandbox box({"glass", 2500, 1e9, 0.2}, {e, 0, k, k}, 0.001 / omega0);
        box.scene.contact.normal = scene::NormalLaw::linear;
        box.scene.contact.tangential = scene::TangentialLaw::linear;
        box.scene.contact.limit_force = true;
        box.wall(scene::PlaneShape{});
        box.start({placed(box.ball(r), {0, r + 1e-9, 0}, {0, -1, 0})});
        box.run(5000);
        // Granular Matter 9 (2007) 465: x'' + 2 b x' + omega0^2 x = 0 until x'' = 0.
        const double b = omega0 * -std::log(e) / std::hypot(std::log(e), std::numbers::pi);
        const double omega = std::sqrt(omega0 * omega0 - b * b);
        const double predicted =
            std::exp(-b / omega * (std::numbers::pi - std::atan(2 * b * omega / (omega * omega - b * b))));
        CHECK(predicted > 1.01 * e);
        CHECK(box.body_now(0).velocity.y() == about(predicted, 2e-3));
        CHECK(std::abs(books_of(*box.world).closure) < 1e-3 * 0.5 * mass);
    }
}

TEST_CASE("the books close also where gravity points along a period") {
    Sandbox box({"glass", 2500, 1e7, 0.25}, {0.5, 0.3}, 1e-4);
    box.scene.gravity = {3, -4, 5};
    box.scene.domain = {{{0, 0, 0}, {0.5, 0.6, 0.7}}, {true, true, true}};
    box.start({placed(box.ball(0.01), {0.1, 0.2, 0.3}, {1, 0, 0})});
    box.run(20000); // through the box a dozen times
    const Books books = books_of(*box.world);
    CHECK(books.kinetic_translation > 50 * 0.5 * ball_mass(0.01, 2500));
    CHECK(std::abs(books.closure) < 1e-9 * books.kinetic_translation);
}

} // namespace test_impact
