#include "about.h"
#include "sandbox.h"
#include "sim2d/world.h"

#include <algorithm>
#include <cmath>

namespace test_rolling {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double g = 9.81;
constexpr double radius = 0.1;
constexpr double stiffness = 1e7; // N/m
constexpr double dt = 2e-5;

/// A disc that rolls at `speed` on a long floor inclined by `slope` (rad): gravity is turned instead.
struct Roller {
    Sandbox box;
    double mass = 0;

    Roller(contact::RollingLaw law, double rolling_friction, double slope, double speed, double rolling_damping = 0.3)
        : box(springs(stiffness, 1, 0.5, 0.6), dt) {
        box.scene.contact.additions.rolling = law;
        box.scene.pairs[0].rolling_friction = rolling_friction;
        box.scene.pairs[0].rolling_damping = rolling_damping;
        box.scene.gravity = {g * std::sin(slope), -g * std::cos(slope), 0};
        box.wall(scene::SegmentShape{{-40, 0}, {40, 0}});
        const int disc = box.disc(radius);
        box.build();
        mass = box.shape(disc).mass;
        box.put({at(disc, {0, radius - mass * g * std::cos(slope) / stiffness}, {speed, 0}, -speed / radius)});
    }
    [[nodiscard]] double speed() const { return box.body_at(0).velocity.x(); }
    [[nodiscard]] double place() const { return box.body_at(0).position.x(); }
    void run_for(double seconds) const { box.step(std::llround(seconds / dt)); }
};

const contact::RollingLaw both[] = {contact::RollingLaw::cdt, contact::RollingLaw::epsd};

} // namespace

TEST_CASE("a rolling disc stops after 3 v^2 / (4 mu_r g), and all it had is booked as lost to rolling") {
    for (const auto law : both) {
        CAPTURE(static_cast<int>(law));
        const double v = 0.5, mu_r = 0.05;
        const Roller disc(law, mu_r, 0, v, 0); // while the spring is wound up the dashpot would take its share
        const double stops_after = 1.5 * v / (mu_r * g); // s, at 2/3 mu_r g
        disc.run_for(0.5 * stops_after);
        CHECK(disc.speed() == about(0.5 * v, 5e-3));
        disc.run_for(0.7 * stops_after);
        CHECK(disc.place() == about(0.75 * v * v / (mu_r * g), 5e-3));
        const double energy = 0.75 * disc.mass * v * v;
        const Books books = books_of(*disc.box.world);
        CHECK(books.lost_rolling == about(energy, 5e-3));
        CHECK(std::abs(books.closure) < 1e-3 * energy);
    }
}

TEST_CASE("down an incline a disc rolls with 2/3 g (sin - mu_r cos)") {
    const double slope = 0.15, mu_r = 0.08;
    for (const auto law : both) {
        CAPTURE(static_cast<int>(law));
        const Roller disc(law, mu_r, slope, 0);
        disc.run_for(0.2);
        const double before = disc.speed();
        disc.run_for(0.3);
        CHECK((disc.speed() - before) / 0.3 == about(2.0 / 3 * g * (std::sin(slope) - mu_r * std::cos(slope)), 5e-3));
    }
}

TEST_CASE("viscous rolling of a disc dies away as exp(-2/3 g tau t / R)") {
    const double v = 0.5, tau = 0.02, rate = 2.0 / 3 * g * tau / radius; // 1/s
    Roller disc(contact::RollingLaw::none, 0, 0, v);
    disc.box.scene.pairs[0].rolling_time = tau;
    disc.box.build();
    disc.box.put({at(0, {0, radius - disc.mass * g / stiffness}, {v, 0}, -v / radius)});
    disc.run_for(0.6);
    CHECK(disc.speed() == about(v * std::exp(-0.6 * rate), 5e-3));
    CHECK(books_of(*disc.box.world).lost_rolling ==
          about(0.75 * disc.mass * v * v * (1 - std::exp(-1.2 * rate)), 5e-3));
}

TEST_CASE("a disc holds on a slope whose tangent is below mu_r") {
    for (const auto law : both) {
        CAPTURE(static_cast<int>(law));
        const Roller disc(law, 0.1, std::atan(0.09), 0);
        disc.run_for(0.3);
        const double rests_at = disc.place();
        disc.run_for(0.5);
        CHECK(std::abs(disc.place() - rests_at) < 1e-3 * radius);
    }
}

TEST_CASE("the rolling spring of discs is 3 k_n (mu_r R*)^2: a disc at rest on it swings with that stiffness") {
    // Let go on a slope it swings about where the spring bears m g R sin: w^2 = k_r / (3/2 m R^2).
    const double mu_r = 0.1, slope = std::atan(0.02);
    Roller disc(contact::RollingLaw::epsd, mu_r, slope, 0, 0);
    disc.box.scene.pairs[0].restitution = 1;
    disc.box.build();
    disc.box.put({at(0, {0, radius - disc.mass * g * std::cos(slope) / stiffness})});
    const double omega = std::sqrt(3 * stiffness * mu_r * mu_r / (1.5 * disc.mass));
    const double half = std::numbers::pi / omega;
    disc.run_for(half);
    // The far point of the swing: twice the angle of rest, and no speed.
    const double rest = disc.mass * g * std::sin(slope) * radius / (3 * stiffness * std::pow(mu_r * radius, 2));
    // There the floor holds back m g sin and slows down m (2/3) g sin, and its shear spring gives way to both; that it
    // was let go at once makes it ring by a third of m g sin, half a percent of the way.
    const double sheared = 5.0 / 3 * disc.mass * g * std::sin(slope) / stiffness;
    CHECK(disc.place() == about(2 * rest * radius + sheared, 0.007));
    CHECK(std::abs(disc.speed()) < 0.1 * rest * radius * omega);
}

TEST_CASE("with rolling resistance too one thread and two give the same bits, and the books close") {
    const auto crowd = [](int threads) {
        Sandbox box(springs(4e6, 0.5, 0.6, 0.4), 5e-5);
        box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
        box.scene.pairs[0].rolling_friction = 0.1;
        box.scene.pairs[0].sliding_friction = 0.2;
        box.scene.pairs[0].sliding_speed = 0.1;
        box.scene.pairs[0].restitution_exponent = 0.2;
        box.scene.pairs[0].restitution_speed = 1;
        box.scene.gravity = {0, -9.81, 0};
        box.scene.domain.box = {{-1, -1, -0.5}, {3, 6, 0.5}};
        scene::BoxShape shape;
        shape.box = {{0, 0, -0.5}, {2, 5, 0.5}};
        box.wall(shape).motion.harmonics = {{{}, 1, 0.02, 8, 0}};
        box.disc(0.03);
        box.body({{{0, 0, 0}, 0.03}, {{0.04, 0, 0}, 0.02}});
        for (int body = 0; body < 2; ++body) {
            scene::Fill fill;
            fill.body = body;
            fill.count = body == 0 ? 250 : 150;
            fill.region = {{0, 0, -0.5}, {2, 3, 0.5}};
            box.scene.fills.push_back(fill);
        }
        box.build(threads);
        box.step(10000);
        return box;
    };
    const Sandbox one = crowd(1), two = crowd(2);
    const auto a = bodies_of(*one.world), b = bodies_of(*two.world);
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(a[i].position == b[i].position);
        REQUIRE(a[i].angular_velocity == b[i].angular_velocity);
    }
    const Books books = books_of(*one.world);
    CHECK(books.closure == books_of(*two.world).closure);
    CHECK(books.lost_rolling > 0);
    CHECK(std::abs(books.closure) < 5e-3 * (books.inserted + books.wall_work));
}

TEST_CASE("a rolling friction of 0 changes no bit of discs, whatever the law") {
    const auto fate = [](contact::RollingLaw law, bool by_the_full_law) {
        Sandbox box(springs(1e6, 0.7, 0.6, 0.4), dt);
        box.scene.contact.additions.rolling = law;
        box.scene.gravity = {0.4, -g, 0};
        box.wall(scene::SegmentShape{{-10, 0}, {10, 0}});
        const int disc = box.disc(radius);
        box.build();
        if (by_the_full_law) {
            box.world->remembers_more = true;
            for (contact::PairConstants& pair : box.world->pairs)
                pair.rolling = law;
        }
        box.put({at(disc, {0, 0.2}, {0.1, 0}, 3), at(disc, {0.05, 0.5}), at(disc, {-0.1, 0.8}, {0, -1})});
        box.step(20000);
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
