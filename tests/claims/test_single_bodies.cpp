#include "about.h"
#include "claims.h"
#include "sim3d/solver.h"

#include <algorithm>
#include <cmath>

namespace test_single_bodies {

using namespace tumble;
using namespace tumble::test;

namespace {

sim3d::WorldPtr stepped(const scene::Scene& scene) {
    auto world = sim3d::build_world(scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    const auto problem = sim3d::advance(**world, std::llround(scene.duration / scene.time_step));
    REQUIRE(!problem);
    return std::move(*world);
}

} // namespace

TEST_CASE("drop: the sphere rebounds to e^2 h less what gravity takes during the contact") {
    const Ran drop(loaded("drop.toml"));
    const std::vector<double>& time = drop.column("time");
    const std::vector<double>& height = drop.column("centre_of_mass_y");
    double top = 0;
    for (std::size_t row = 0; row < time.size(); ++row)
        if (time[row] > 0.21) // after the contact, at sqrt(2 h / g) = 0.202 s
            top = std::max(top, height[row] - 0.01275);
    const double rebound = 0.67 * 0.67 * 0.2;
    CHECK(top < rebound);
    CHECK(top > rebound * (1 - 0.005));
}

TEST_CASE(
    "bounce: every bounce reaches 0.8^2 of the height before, less some 1 % that gravity takes during the contact") {
    const Ran ran(loaded("bounce.toml", {"observe.measures=[\"centre_of_mass_y\"]"}));
    const auto highest = [&](double from, double to) {
        double most = 0;
        for (std::size_t row = 0; row < ran.series.rows(); ++row)
            if (ran.column("time")[row] > from && ran.column("time")[row] < to)
                most = std::max(most, ran.column("centre_of_mass_y")[row] - 0.12);
        return most;
    };
    // Impacts at sqrt(2 h / g) = 0.45 s, then after flights of 2 * 0.8^n * 0.45 s: 1.17 s, 1.75 s.
    const double first = highest(0.5, 1.15), second = highest(1.25, 1.72);
    CHECK(first > 0.625);
    CHECK(first < 0.64);
    CHECK(second / first > 0.625);
    CHECK(second / first < 0.64);
}

TEST_CASE("oblique: the sphere leaves as the hard-sphere result for full sliding says") {
    const sim3d::WorldPtr world = stepped(loaded("oblique.toml"));
    const sim3d::BodyState ball = sim3d::bodies_of(*world).front();
    CHECK(ball.velocity.x() / 2.50687 == about(0.7829, 0.002));
    CHECK(ball.angular_velocity.norm() == about(544.2, 0.002));
}

TEST_CASE("lane: the ball slides by mu g, then rolls with 5/7 of its speed") {
    const Ran ran(loaded("lane.toml", {"observe.measures=[\"centre_of_mass_x\"]"}));
    const auto way = [&](double t) { return ran.at("centre_of_mass_x", t); };
    // It turns on an arm that is 0.16 % short of the radius, which takes 0.1 % of the speed.
    CHECK(way(0.3) == about(2.5 * 0.3 - 0.5 * 0.2 * 9.81 * 0.3 * 0.3, 0.003));
    CHECK(way(2.9) - way(1.9) == about(5.0 / 7 * 2.5, 0.003));
}

TEST_CASE("slope: the tripod slides down with g (sin a - mu cos a)") {
    const Ran ran(loaded("slope.toml", {"observe.measures=[\"centre_of_mass_x\"]"}));
    const auto way = [&](double t) { return ran.at("centre_of_mass_x", t); };
    CHECK((way(0.99) - 2 * way(0.69) + way(0.39)) / (0.3 * 0.3) == about(0.866, 0.01));
}

TEST_CASE("plate: the ball leaves where the plate slows down by g, and flies from there") {
    const Ran ran(
        loaded("plate.toml", {"observe.measures=[\"centre_of_mass_y\"]", "duration_s=0.06", "observe.every_s=0.0005"}));
    const std::vector<double>& height = ran.column("centre_of_mass_y");
    CHECK(*std::max_element(height.begin(), height.end()) - 0.01 == about(0.00699, 0.01));
}

TEST_CASE("settle-cones: the cones come to rest and the books close") {
    const Ran settle(loaded("settle-cones.toml"));
    CHECK(settle.summary.bodies == 40);
    const std::vector<double>& kinetic = settle.column("kinetic_energy");
    CHECK(*std::max_element(kinetic.begin(), kinetic.end()) > 0.05);
    CHECK(kinetic.back() < 1e-6);
    CHECK(std::abs(settle.summary.books.closure) < 1e-3);
}

} // namespace test_single_bodies
