#include "about.h"
#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <algorithm>
#include <cmath>

namespace test_rolling {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double g = 9.81;      // m/s2
constexpr double radius = 0.01; // m
constexpr double dt = 1e-5;     // s
const contact::Material soft{"glass", 2500, 5e7, 0.25};

contact::PairProperties rolling_pair(double rolling_friction, double rolling_damping = 0.3) {
    contact::PairProperties pair;
    pair.restitution = 0.5;
    pair.friction = 0.6;
    pair.rolling_friction = rolling_friction;
    pair.rolling_damping = rolling_damping;
    return pair;
}

/// A ball that rolls on a plane inclined by `slope` (rad), x downhill: gravity is turned instead.
struct Roller {
    Sandbox box;
    double mass = 0;

    Roller(contact::RollingLaw law, double rolling_friction, double slope, double speed, double rolling_damping = 0.3)
        : Roller(law, rolling_pair(rolling_friction, rolling_damping), slope, speed) {}
    Roller(contact::RollingLaw law, const contact::PairProperties& pair, double slope, double speed)
        : box(soft, pair, dt) {
        box.scene.contact.additions.rolling = law;
        box.scene.gravity = {g * std::sin(slope), -g * std::cos(slope), 0};
        box.wall(scene::PlaneShape{});
        const int ball = box.ball(radius);
        const double m = mass = 2500 * 4.0 / 3 * 3.14159265358979 * radius * radius * radius;
        const double E_eff = 5e7 / (2 * (1 - 0.25 * 0.25));
        const double sunk = std::pow(0.75 * m * g * std::cos(slope) / (E_eff * std::sqrt(radius)), 2.0 / 3);
        box.start({placed(ball, {0, radius - sunk, 0}, {speed, 0, 0}, {0, 0, -speed / radius})});
    }
    [[nodiscard]] double place() const { return box.body_now(0).position.x(); }
    [[nodiscard]] double speed() const { return box.body_now(0).velocity.x(); }
    void run_for(double seconds) { box.run(std::llround(seconds / dt)); }
    /// Energy that the books miss, over all that was put in.
    [[nodiscard]] double missed(double put_in) const { return std::abs(books_of(*box.world).closure) / put_in; }
};

contact::PairProperties viscous_pair(double tau) {
    contact::PairProperties pair = rolling_pair(0);
    pair.rolling_time = tau;
    return pair;
}

const contact::RollingLaw both[] = {contact::RollingLaw::cdt, contact::RollingLaw::epsd};

} // namespace

TEST_CASE("without rolling resistance a ball on a plane rolls on and on") {
    Roller ball(contact::RollingLaw::none, 0.05, 0, 0.2);
    ball.run_for(1);
    CHECK(ball.place() == about(0.2, 1e-3));
    CHECK(ball.speed() == about(0.2, 1e-3));
}

TEST_CASE("a rolling ball stops after 7 v^2 / (10 mu_r g), and all it had is booked as lost to rolling") {
    for (const auto law : both) {
        CAPTURE(static_cast<int>(law));
        const double v = 0.2, mu_r = 0.05;
        Roller ball(law, mu_r, 0, v, 0);
        const double stops_after = 7 * v / (5 * mu_r * g); // s, at 5/7 mu_r g
        ball.run_for(0.5 * stops_after);
        CHECK(ball.speed() == about(0.5 * v, 5e-3));
        ball.run_for(0.7 * stops_after);
        CHECK(ball.place() == about(7 * v * v / (10 * mu_r * g), 5e-3));
        const double energy = 0.7 * ball.mass * v * v;
        const Books books = books_of(*ball.box.world);
        CHECK(books.lost_rolling == about(energy, 5e-3));
        CHECK(books.kinetic_translation + books.kinetic_rotation < 2e-3 * energy); // the spring swings
        CHECK(ball.missed(energy) < 1e-3);
    }
}

TEST_CASE(
    "viscous rolling dies away as exp(-5/7 g tau t / R) and is booked as lost; down a slope it tends to a speed") {
    const double v = 0.2, tau = 0.004, rate = 5.0 / 7 * g * tau / radius; // 1/s
    Roller ball(contact::RollingLaw::none, viscous_pair(tau), 0, v);
    for (const double time : {0.2, 0.4, 0.8}) {
        ball.run_for(time - static_cast<double>(steps_of(*ball.box.world)) * dt);
        CHECK(ball.speed() == about(v * std::exp(-rate * time), 3e-3));
        CHECK(ball.place() == about(v / rate * (1 - std::exp(-rate * time)), 3e-3));
    }
    const double energy = 0.7 * ball.mass * v * v;
    const Books books = books_of(*ball.box.world);
    CHECK(books.lost_rolling == about(energy * (1 - std::exp(-1.6 * rate)), 5e-3));
    CHECK(ball.missed(energy) < 1e-3);
    const double slope = 0.02;
    Roller rolls(contact::RollingLaw::none, viscous_pair(10 * tau), slope, 0);
    rolls.run_for(0.5); // fourteen times its time
    CHECK(rolls.speed() == about(std::tan(slope) * radius / (10 * tau), 3e-3));
}

TEST_CASE("while the rolling spring is wound up its dashpot takes 4 eta_r theta omega_r / omega of the energy") {
    // theta the angle of yield, omega_r the spring's frequency; the rest stops the ball as before, half of theta later.
    const double v = 0.2, mu_r = 0.05, eta = 0.3;
    Roller ball(contact::RollingLaw::epsd, mu_r, 0, v, eta);
    const double E_eff = 5e7 / (2 * (1 - 0.25 * 0.25)), press = ball.mass * g;
    const double sunk = std::pow(0.75 * press / (E_eff * std::sqrt(radius)), 2.0 / 3);
    const double yield = sunk / (2.25 * mu_r * radius);
    const double omega_r = std::sqrt(2.25 * press / sunk * mu_r * mu_r / (1.4 * ball.mass));
    const double share = 4 * eta * yield * omega_r * radius / v;
    CHECK(share > 0.02);
    double farthest = 0;
    for (int k = 0; k < 140; ++k) {
        ball.run_for(0.005);
        farthest = std::max(farthest, ball.place());
    }
    CHECK(farthest == about(7 * v * v / (10 * mu_r * g) * (1 - share) + 0.5 * yield * radius, 5e-3));
}

TEST_CASE("down an incline a ball rolls with 5/7 g (sin - mu_r cos), and the books close") {
    const double slope = 0.15, mu_r = 0.08;
    for (const auto law : both) {
        CAPTURE(static_cast<int>(law));
        Roller ball(law, mu_r, slope, 0);
        ball.run_for(0.3);
        const double before = ball.speed();
        ball.run_for(0.3);
        const double a = 5.0 / 7 * g * (std::sin(slope) - mu_r * std::cos(slope));
        CHECK((ball.speed() - before) / 0.3 == about(a, 5e-3));
        CHECK(ball.missed(ball.mass * g * std::sin(slope) * ball.place()) < 1e-3);
    }
}

TEST_CASE("a ball holds on a slope whose tangent is below mu_r, and rolls off one above") {
    const double mu_r = 0.1;
    for (const auto law : both) {
        CAPTURE(static_cast<int>(law));
        Roller held(law, mu_r, std::atan(0.9 * mu_r), 0);
        held.run_for(0.2); // the spring stretches
        const double rests_at = held.place();
        held.run_for(0.5);
        // Turning round in every step the constant torque lets it creep; a centimetre takes minutes.
        CHECK(std::abs(held.place() - rests_at) < (law == contact::RollingLaw::cdt ? 4e-3 : 1e-5) * radius);
        const double slope = std::atan(1.1 * mu_r);
        Roller rolls(law, mu_r, slope, 0);
        rolls.run_for(0.3); // until the spring has given way
        const double before = rolls.speed();
        rolls.run_for(0.4);
        CHECK((rolls.speed() - before) / 0.4 == about(5.0 / 7 * g * (std::sin(slope) - mu_r * std::cos(slope)), 0.01));
    }
}

TEST_CASE("at rest the constant torque shakes a ball in every step, the spring and its dashpot bring it to rest") {
    const auto spin_at_rest = [](contact::RollingLaw law) {
        Roller ball(law, 0.1, 0, 0.02);
        ball.run_for(0.8);
        double most = 0;
        for (int k = 0; k < 100; ++k) {
            ball.box.run(1);
            most = std::max(most, std::abs(ball.box.body_now(0).angular_velocity.z()));
        }
        return most;
    };
    // Torque mu_r R m g, half a step long, on 7/5 m R^2.
    const double shaken = 0.5 * dt * 0.1 * g / (1.4 * radius);
    CHECK(spin_at_rest(contact::RollingLaw::cdt) > 0.3 * shaken);
    CHECK(spin_at_rest(contact::RollingLaw::epsd) < 1e-3 * shaken);
}

TEST_CASE("a ball in a turning drum is rolled along by the wall: what counts is the spin relative to it") {
    Sandbox box(soft, rolling_pair(0.3), dt);
    box.scene.contact.additions.rolling = contact::RollingLaw::cdt;
    scene::Wall& cylinder = box.wall(scene::CylinderShape{{0, 0, -0.1}, {0, 0, 1}, 0.2, 0.05});
    cylinder.motion.rotations.push_back({{}, {0, 0, 0}, {0, 0, 1}, 4.0});
    const int ball = box.ball(radius);
    // Carried round like a part of the drum, without gravity: it spins as the drum does and rolls not at all.
    const double way = 0.04, omega = 4;
    const double push = 2500 * 4.0 / 3 * 3.14159265358979 * std::pow(radius, 3) * omega * omega * way;
    const double E_eff = 5e7 / (2 * (1 - 0.25 * 0.25));
    const double sunk = std::pow(0.75 * push / (E_eff * std::sqrt(radius)), 2.0 / 3);
    box.start({placed(ball, {way + sunk, 0, 0}, {0, omega * (way + sunk), 0}, {0, 0, omega})});
    box.run(20000);
    const Books books = books_of(*box.world);
    const double energy = books.kinetic_rotation + books.kinetic_translation;
    CHECK(box.body_now(0).angular_velocity.z() == about(omega, 1e-3));
    CHECK(books.lost_rolling < 1e-3 * energy);
    CHECK(std::abs(books.closure) < 1e-3 * energy);
}

TEST_CASE("a ball rests a little beside the top of a greater one, by what their contact remembers") {
    // Tilt f holds where tan f <= mu_r R* / r on the small ball, and m (R + r) sin f <= mu_r R (M + m) below the large.
    const double large = 0.02, small = 0.005, tilt = 0.02;
    for (const double skin : {1e-5, 4e-3}) {
        CAPTURE(skin);
        Sandbox box(soft, rolling_pair(0.1), dt);
        box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
        box.scene.gravity = {0, -g, 0};
        box.scene.skin = skin;
        box.wall(scene::PlaneShape{});
        const int below = box.ball(large), above = box.ball(small);
        const Vector3d up(std::sin(tilt), std::cos(tilt), 0);
        // Others fly past and wear the lists out.
        std::vector<BodyState> bodies{placed(above, Vector3d(0, large, 0) + (large + small) * up),
                                      placed(below, {0, large, 0})};
        for (int k = 0; k < 4; ++k)
            bodies.push_back(placed(above, {0.1 * k - 0.2, 0.2, 0.1}, {1, 2, 0}));
        box.start(bodies);
        box.run(30000);
        CHECK(box.world->rebuilds > (skin < 1e-4 ? 200 : 5));
        const Vector3d between = box.body_now(0).position - box.body_now(1).position;
        CHECK(between.x() / between.norm() == about(std::sin(tilt), 0.05));
        CHECK(box.body_now(0).velocity.norm() < 1e-4);
        CHECK(books_of(*box.world).stored_rolling > 0);
    }
}

TEST_CASE("a rolling friction of 0 changes no bit, whatever the law") {
    const auto fate = [](contact::RollingLaw law, bool by_the_full_law) {
        Sandbox box(soft, rolling_pair(0), dt);
        box.scene.contact.additions.rolling = law;
        box.scene.gravity = {0.5, -g, 0.2};
        box.wall(scene::PlaneShape{});
        const int ball = box.ball(radius);
        const int clump = box.body({{{0, 0, 0}, radius}, {{radius, 0, 0}, radius}});
        box.start({placed(ball, {0, 0.02, 0}, {0.1, 0, 0}, {3, 4, 5}), placed(clump, {0, 0.06, 0.003}),
                   placed(ball, {0.002, 0.09, 0})});
        if (by_the_full_law) {
            box.world->remembers_more = true;
            for (contact::PairConstants& pair : box.world->pairs)
                pair.rolling = law;
        }
        box.run(20000);
        return bodies_of(*box.world);
    };
    const auto plain = fate(contact::RollingLaw::none, false);
    for (const auto law : both)
        for (const bool by_the_full_law : {false, true}) {
            const auto other = fate(law, by_the_full_law);
            for (std::size_t k = 0; k < plain.size(); ++k) {
                CHECK(plain[k].position == other[k].position);
                CHECK(plain[k].velocity == other[k].velocity);
                CHECK(plain[k].angular_velocity == other[k].angular_velocity);
            }
        }
}

} // namespace test_rolling
