#include "about.h"
#include "sim3d/sandbox.h"

#include <cmath>
#include <numbers>

namespace test_air {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double g = 9.81;   // m/s2
constexpr double r = 2e-3;   // m
constexpr double light = 30; // kg/m3, foam
constexpr double dt = 1e-4;  // s

double sphere(double radius) {
    return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

/// Bodies fall from y = 0 through air, each 1 m from the next.
Sandbox falling(const contact::Air& air, const std::vector<std::vector<scene::Sphere>>& shapes) {
    Sandbox box({"foam", light, 1e7, 0.25}, {0.5, 0.3}, dt);
    box.scene.gravity = {0, -g, 0};
    box.scene.air = air;
    std::vector<BodyState> bodies;
    for (const auto& spheres : shapes)
        bodies.push_back(placed(box.body(spheres), {static_cast<double>(bodies.size()), 0, 0}));
    box.start(bodies);
    return box;
}

} // namespace

TEST_CASE("in air without viscosity a ball falls as v_t tanh(g t / v_t), through v_t^2 / g ln cosh(g t / v_t)") {
    Sandbox box = falling({1.2, 0, 0.44}, {{{{0, 0, 0}, r}}});
    // m g = rho C_d / 2 pi r^2 v_t^2
    const double terminal = std::sqrt(light * sphere(r) * g / (0.5 * 1.2 * 0.44 * std::numbers::pi * r * r));
    for (const double time : {0.1, 0.3, 1.2}) {
        box.run(std::llround(time / dt) - steps_of(*box.world));
        const double reached = g * time / terminal;
        CHECK(-box.body_now(0).velocity.y() == about(terminal * std::tanh(reached), 1e-3));
        CHECK(-box.body_now(0).position.y() == about(terminal * terminal / g * std::log(std::cosh(reached)), 1e-3));
    }
    CHECK(-box.body_now(0).velocity.y() > 0.99 * terminal);
    const Books books = books_of(*box.world);
    CHECK(books.lost_air_drag > 0.5 * -books.gravity);
    CHECK(std::abs(books.closure) < 1e-4 * books.lost_air_drag);
}

TEST_CASE("in a viscous medium a ball falls as v_t (1 - exp(-t / tau)) with Stokes' v_t = 2 r^2 rho g / (9 mu)") {
    const double mu = 1e-3;
    Sandbox box = falling({0, mu, 0.44}, {{{{0, 0, 0}, r}}});
    const double terminal = 2 * r * r * light * g / (9 * mu), tau = terminal / g;
    for (const double time : {0.5 * tau, tau, 5 * tau}) {
        box.run(std::llround(time / dt) - steps_of(*box.world));
        const double now = time_of(*box.world);
        CHECK(-box.body_now(0).velocity.y() == about(terminal * (1 - std::exp(-now / tau)), 2e-3));
    }
    const Books books = books_of(*box.world);
    CHECK(std::abs(books.closure) < 2e-3 * books.lost_air_drag);
}

TEST_CASE("a clump is dragged as the sphere of its volume") {
    // Two spheres that do not overlap: twice the volume.
    Sandbox box =
        falling({1.2, 1e-3, 0.44}, {{{{-2 * r, 0, 0}, r}, {{2 * r, 0, 0}, r}}, {{{0, 0, 0}, r * std::cbrt(2.0)}}});
    box.run(3000);
    CHECK(box.body_now(0).velocity.y() == about(box.body_now(1).velocity.y(), 1e-3));
}

TEST_CASE("drag stops a body and never turns it round, however strong it is") {
    Sandbox box = falling({0, 1e4, 0}, {{{{0, 0, 0}, r}}});
    box.scene.gravity = Vector3d::Zero();
    box.start({placed(0, {0, 0, 0}, {1, 0, 0})});
    for (int k = 0; k < 20; ++k) {
        box.run(1);
        CHECK(std::abs(box.body_now(0).velocity.x()) <= 1);
    }
}

TEST_CASE("air of no density and no viscosity changes no bit") {
    const auto fate = [](const contact::Air& air) {
        Sandbox box = falling(air, {{{{0, 0, 0}, r}}});
        box.run(1000);
        return box.body_now(0);
    };
    CHECK(fate({0, 0, 0.44}).position == fate({}).position);
    CHECK(fate({1.2, 0, 0}).position == fate({}).position);
}

} // namespace test_air
