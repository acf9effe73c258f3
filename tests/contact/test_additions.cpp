#include "about.h"
#include "contact/cundall_strack.h"
#include "contact/full_discs.h"
#include "contact/full_law.h"
#include "contact/hertz_discs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

namespace test_additions {

using namespace tumble;
using namespace tumble::contact;
using tumble::test::about;

namespace {

using Vec = Vec3<double>;
using TUMBLE_ISA::Pack;

constexpr double dt = 1e-7; // s
const Material glass{"glass", 2500, 7e10, 0.24};

PairProperties rubbing() {
    PairProperties pair;
    pair.restitution = 0.4;
    pair.friction = 0.3;
    pair.normal_stiffness = 2e5;
    pair.tangential_stiffness = 1.5e5;
    return pair;
}

PairConstants rolling(RollingLaw law, double friction, double damping = 0) {
    PairProperties pair = rubbing();
    pair.rolling_friction = friction;
    pair.rolling_damping = damping;
    return derive(glass, glass, pair, {law});
}

/// With every addition at work.
PairConstants everything(RollingLaw law) {
    PairProperties pair = rubbing();
    pair.rolling_friction = 0.2;
    pair.restitution_exponent = 0.25;
    pair.restitution_speed = 1;
    pair.sliding_friction = 0.1;
    pair.sliding_speed = 0.05;
    pair.rolling_time = 0.01;
    pair.sticking_speed = 0.02;
    return derive(glass, glass, pair, {law});
}

const Memory<double> fresh{{0, 0, 0}, 0};
const Further<double> just_begun{fresh, 0, 0, 0};

Touch<double> touch_of(int k) {
    return {1e-7 * (k + 1), {0.6, 0, 0.8}, {0.1 * k - 0.4, 0.3 * k, -0.05 * k * k}, 2e-3, 5e-5, 1};
}
Turn<double> turn_of(int k) {
    return {{3.0 * k - 7, 11.0 - k * k, 2.0 + k}, 3e-10};
}

bool same(const Vec& a, const Vec& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Rolls a contact of fixed overlap about z through these angles (rad), one after the other; `each` sees every push.
template <class Each>
void roll(const PairConstants& pair, const Touch<double>& touch, const std::vector<double>& corners, Each&& each) {
    constexpr int steps = 2000; // a leg
    Further<double> further = just_begun;
    double at = 0;
    for (const double corner : corners) {
        for (int k = 0; k < steps; ++k) {
            const Turn<double> turn{{0, 0, (corner - at) / steps / dt}, 1e20};
            const auto push = FullLaw<Hertz, Mindlin>{}.push(touch, turn, pair, fresh, further, dt);
            further = push.further;
            each(push, turn.spin.z * dt);
        }
        at = corner;
    }
}

const Touch<double> pressed{1e-6, {1, 0, 0}, {0, 0, 0}, 2e-3, 5e-5, 1};
/// N, of that touch under Hertz.
double press(const PairConstants& pair) {
    return 4.0 / 3 * pair.E_eff * std::sqrt(2e-3 * 1e-6) * 1e-6;
}

} // namespace

TEST_CASE_TEMPLATE("a pair without additions is pushed by FullLaw as by Law, bit for bit", Pairing,
                   std::pair<Hertz, Mindlin>, std::pair<Hertz, NoTangential>,
                   std::pair<LinearNormal, LinearTangential>) {
    using Normal = typename Pairing::first_type;
    using Tangential = typename Pairing::second_type;
    PairConstants plain = derive(glass, glass, rubbing());
    REQUIRE(plain.plain());
    PairConstants zero = plain; // laws chosen, their parameters 0
    for (const RollingLaw law : {RollingLaw::none, RollingLaw::cdt, RollingLaw::epsd}) {
        zero.rolling = law;
        for (int k = 0; k < 8; ++k) {
            const auto one = Law<Normal, Tangential>{}.push(touch_of(k), plain, fresh, dt);
            const auto full = FullLaw<Normal, Tangential>{}.push(touch_of(k), turn_of(k), zero, fresh, just_begun, dt);
            CHECK(same(one.force, full.force));
            CHECK(same(one.memory.spring, full.memory.spring));
            CHECK(one.memory.energy == full.memory.energy);
            CHECK(one.stored_normal == full.stored_normal);
            CHECK(one.lost_normal_damping == full.lost_normal_damping);
            CHECK(one.lost_tangential_damping == full.lost_tangential_damping);
            CHECK(one.lost_sliding == full.lost_sliding);
            CHECK(one.lost_history == full.lost_history);
            CHECK(same(full.torque, {0, 0, 0}));
            CHECK(full.lost_rolling_damping + full.lost_rolling_sliding == 0);
        }
    }
}

TEST_CASE("a law is added only where the pair has a parameter for it") {
    CHECK(rolling(RollingLaw::epsd, 0).plain());
    CHECK(rolling(RollingLaw::none, 0.1).plain());
    CHECK(!rolling(RollingLaw::cdt, 0.1).plain());
    PairProperties pair = rubbing();
    pair.sliding_friction = pair.friction;
    pair.sliding_speed = 1;
    CHECK(derive(glass, glass, pair).plain());
}

TEST_CASE("constant directional torque: mu_r R* F_n against what rolls, nothing against what twists") {
    const PairConstants pair = rolling(RollingLaw::cdt, 0.15);
    const double expected = 0.15 * 2e-3 * press(pair);
    for (const double speed : {1e-6, 1.0, 1e4}) {
        const Turn<double> turn{{50, 3 * speed, -4 * speed}, 1e20};
        const auto push = FullLaw<Hertz, Mindlin>{}.push(pressed, turn, pair, fresh, just_begun, dt);
        CHECK(push.torque.x == 0);
        CHECK(push.torque.y == about(-0.6 * expected));
        CHECK(push.torque.z == about(0.8 * expected));
        CHECK(push.lost_rolling_damping == about(expected * 5 * speed * dt));
    }
    const auto at_rest = FullLaw<Hertz, Mindlin>{}.push(pressed, {{0, 0, 0}, 1}, pair, fresh, just_begun, dt);
    CHECK(same(at_rest.torque, {0, 0, 0}));
}

TEST_CASE("the rolling spring has the stiffness 2.25 k_n (mu_r R*)^2 and gives way at mu_r R* F_n") {
    const PairConstants pair = rolling(RollingLaw::epsd, 0.15);
    const double limit = 0.15 * 2e-3 * press(pair);
    const double stiffness = 2.25 * (press(pair) / 1e-6) * 0.15 * 0.15 * 2e-3 * 2e-3;
    // So the whole torque is mobilised over the angle d / (2.25 mu_r R*).
    CHECK(limit / stiffness == about(1e-6 / (2.25 * 0.15 * 2e-3)));
    double angle = 0, largest = 0;
    roll(pair, pressed, {3 * limit / stiffness}, [&](const auto& push, double turned) {
        angle += turned;
        CHECK(push.torque.z == about(-std::min(stiffness * angle, limit)));
        largest = std::max(largest, push.further.rolling.energy);
    });
    CHECK(largest == about(limit * limit / (2 * stiffness)));
}

TEST_CASE("rolling to and fro costs what the law books as lost, and less than the yield can hold costs nothing") {
    const PairConstants pair = rolling(RollingLaw::epsd, 0.15);
    const double yield = 1e-6 / (2.25 * 0.15 * 2e-3); // rad
    for (const double reach : {0.9, 4.0}) {
        double work = 0, lost = 0, stored = 0, before = 0;
        roll(pair, pressed, {reach * yield, -reach * yield, reach * yield}, [&](const auto& push, double turned) {
            work -= 0.5 * (before + push.torque.z) * turned;
            before = push.torque.z;
            lost += push.lost_rolling_sliding + push.lost_rolling_damping;
            stored = push.further.rolling.energy;
        });
        CHECK(work == about(lost + stored, 1e-3));
        // Twice the way less the yield on either side, at the limit; the first leg only once.
        const double limit = 0.15 * 2e-3 * press(pair);
        const double expected = limit * yield * (reach > 1 ? (reach - 1) + 2 * (2 * reach - 2) : 0.0);
        CHECK(lost == about(expected, 1e-3));
    }
}

TEST_CASE("the rolling dashpot is eta_r times the critical 2 sqrt(I_r k_r), and silent while the spring gives way") {
    const PairConstants pair = rolling(RollingLaw::epsd, 0.15, 0.3);
    const double stiffness = 2.25 * (press(pair) / 1e-6) * 0.15 * 0.15 * 2e-3 * 2e-3;
    const double inertia = 3e-10;
    const Turn<double> slow{{0, 0, 1e-3}, inertia};
    const auto push = FullLaw<Hertz, Mindlin>{}.push(pressed, slow, pair, fresh, just_begun, dt);
    const double c = 2 * 0.3 * std::sqrt(inertia * stiffness);
    CHECK(push.torque.z == about(-(c + stiffness * dt) * 1e-3));
    const Turn<double> fast{{0, 0, 1e9}, inertia};
    const auto yielding = FullLaw<Hertz, Mindlin>{}.push(pressed, fast, pair, fresh, just_begun, dt);
    CHECK(yielding.torque.z == about(-0.15 * 2e-3 * press(pair)));
    CHECK(yielding.lost_rolling_damping == 0);
}

TEST_CASE("viscous rolling: tau R* F_n times what rolls, nothing of what twists, beside whatever law there is") {
    PairProperties properties = rubbing();
    properties.rolling_time = 0.02;
    const double alone = 0.02 * 2e-3 * press(derive(glass, glass, properties)); // N m s
    for (const RollingLaw law : {RollingLaw::none, RollingLaw::cdt}) {
        properties.rolling_friction = law == RollingLaw::none ? 0 : 0.15;
        const PairConstants pair = derive(glass, glass, properties, {law});
        const double dry = properties.rolling_friction * 2e-3 * press(pair);
        for (const double speed : {1e-6, 1.0, 1e4}) {
            const Turn<double> turn{{50, 3 * speed, -4 * speed}, 1e20};
            const auto push = FullLaw<Hertz, Mindlin>{}.push(pressed, turn, pair, fresh, just_begun, dt);
            CHECK(push.torque.x == 0);
            CHECK(push.torque.y == about(-0.6 * dry - 3 * alone * speed));
            CHECK(push.torque.z == about(0.8 * dry + 4 * alone * speed));
            CHECK(push.lost_rolling_damping == about((dry + 5 * alone * speed) * 5 * speed * dt));
        }
    }
    CHECK(!derive(glass, glass, properties).plain());
}

TEST_CASE("no step is too long for viscous rolling: a spin that is free to turn never grows") {
    PairProperties properties = rubbing();
    properties.rolling_time = 10;
    const PairConstants pair = derive(glass, glass, properties);
    const double turns = 0.4 * 5e-5 * 2e-3 * 2e-3; // kg m2, of a sphere about its centre
    for (const double step : {1e-9, 1e-7, 1e-5, 1e-2, 10.0}) {
        const Turn<double> turn{{0, 0, 100}, turns * 3.5};
        const auto push = FullLaw<Hertz, Mindlin>{}.push(pressed, turn, pair, fresh, just_begun, step);
        const double after = 100 + push.torque.z * step / turns;
        CHECK(std::abs(after) < 100);
        // The rule of the trapezium, which is exp(-c t / I) to second order.
        const double x = 10 * 2e-3 * press(pair) * step / turns;
        CHECK(after == about(100 * (1 - x / 2) / (1 + x / 2), 1e-9));
    }
}

TEST_CASE("friction weakens from mu_s to mu_k over the speed v_c") {
    const PairConstants pair = everything(RollingLaw::none);
    CHECK(friction_at(0.0, pair) == about(0.3));
    CHECK(friction_at(0.05, pair) == about(0.1 + 0.2 / std::exp(1)));
    CHECK(friction_at(5.0, pair) == about(0.1));
}

TEST_CASE("a restitution that falls with speed asks for the damping of e_0 (v / v_0)^-p, at most that of e_most") {
    PairProperties properties = rubbing();
    properties.restitution_exponent = 0.25;
    properties.restitution_speed = 2;
    properties.restitution_most = 0.9;
    const PairConstants pair = derive(glass, glass, properties);
    const auto damping_of = [](double e) {
        PairProperties fixed;
        fixed.restitution = e;
        return derive(glass, glass, fixed).damping;
    };
    CHECK(damping_at(2.0, pair) == about(damping_of(0.4)));
    CHECK(damping_at(32.0, pair) == about(damping_of(0.2)));
    CHECK(damping_at(0.125, pair) == about(damping_of(0.8)));
    CHECK(damping_at(1e-12, pair) == about(damping_of(0.9)));
}

TEST_CASE("surfaces that stick ask for the damping of e sqrt(1 - (v_s / v)^2), and all of the critical below v_s") {
    PairProperties properties = rubbing();
    properties.sticking_speed = 0.3;
    const auto damping_of = [](double e) {
        PairProperties fixed;
        fixed.restitution = e;
        return derive(glass, glass, fixed).damping;
    };
    const PairConstants pair = derive(glass, glass, properties);
    CHECK(pair.damping == 1); // the law scales it
    CHECK(damping_at(0.5, pair) == about(damping_of(0.4 * 0.8)));
    CHECK(damping_at(1e3, pair) == about(damping_of(0.4), 1e-6));
    CHECK(damping_at(0.3, pair) > 0.9999);
    CHECK(damping_at(1e-12, pair) > 0.9999);
    properties.restitution_exponent = 0.25; // and both
    properties.restitution_speed = 2;
    CHECK(damping_at(0.5, derive(glass, glass, properties)) == about(damping_of(0.4 * std::sqrt(2) * 0.8)));
    properties.restitution = 0; // sticks at every speed: nothing to scale
    CHECK(derive(glass, glass, properties).sticking_speed == 0);
}

TEST_CASE("a contact keeps the speed of its impact, and its damping with it") {
    PairProperties properties = rubbing();
    properties.restitution_exponent = 0.25;
    properties.restitution_speed = 1;
    const PairConstants pair = derive(glass, glass, properties);
    Touch<double> touch = pressed;
    touch.velocity = {-0.0625, 0, 0};
    auto push = FullLaw<Hertz, Mindlin>{}.push(touch, {}, pair, fresh, just_begun, dt);
    CHECK(push.further.impact_speed == 0.0625);
    touch.velocity = {3, 0, 0};
    push = FullLaw<Hertz, Mindlin>{}.push(touch, {}, pair, fresh, push.further, dt);
    CHECK(push.further.impact_speed == 0.0625);
    // e(1/16) is 0.4 * 2: the viscous force of a pair with that restitution.
    PairProperties fixed = rubbing();
    fixed.restitution = 0.8;
    CHECK(push.force.x == about(Law<Hertz, Mindlin>{}.push(touch, derive(glass, glass, fixed), fresh, dt).force.x));
}

TEST_CASE("eight contacts with every addition give each the very bits of one alone") {
    for (const RollingLaw law : {RollingLaw::cdt, RollingLaw::epsd}) {
        const PairConstants pair = everything(law);
        Touch<Pack> touch{};
        Turn<Pack> turn{};
        for (int k = 0; k < 8; ++k) {
            const Touch<double> one = touch_of(k);
            const Turn<double> spins = turn_of(k);
            const auto put = [&](Vec3<Pack>& to, const Vec& from) {
                to.x.v[k] = from.x;
                to.y.v[k] = from.y;
                to.z.v[k] = from.z;
            };
            put(touch.normal, one.normal);
            put(touch.velocity, one.velocity);
            put(turn.spin, spins.spin);
            touch.overlap.v[k] = one.overlap;
            touch.radius.v[k] = one.radius;
            touch.mass.v[k] = one.mass;
            touch.damping_share.v[k] = one.damping_share;
            turn.inertia.v[k] = spins.inertia;
        }
        const auto eight = FullLaw<Hertz, Mindlin>{}.push(touch, turn, pair, Memory<Pack>{}, Further<Pack>{}, Pack(dt));
        for (int k = 0; k < 8; ++k) {
            const auto one = FullLaw<Hertz, Mindlin>{}.push(touch_of(k), turn_of(k), pair, fresh, just_begun, dt);
            CHECK(eight.force.x.v[k] == one.force.x);
            CHECK(eight.torque.y.v[k] == one.torque.y);
            CHECK(eight.further.impact_speed.v[k] == one.further.impact_speed);
            CHECK(eight.further.rolling.energy.v[k] == one.further.rolling.energy);
            CHECK(eight.lost_rolling_damping.v[k] == one.lost_rolling_damping);
        }
    }
}

TEST_CASE("discs without additions are pushed by FullDiscs as by their law, bit for bit") {
    PairProperties properties = rubbing();
    properties.stiffness_ratio = 0.7;
    properties.tangential_stiffness = 0;
    const PairConstants pair = derive(glass, glass, properties);
    const auto compare = [&](const auto& law) {
        using DiscLaw = std::decay_t<decltype(law)>;
        for (int k = 0; k < 8; ++k) {
            const DiscTouch<double> touch{1e-6 * k, 0.1 * k - 0.3, 0.4 - 0.1 * k * k, 0.01, 0.2};
            const DiscMemory<double> memory{0.1, 0.2};
            const auto one = law.push(touch, memory, 1e-6);
            const auto full = FullDiscs<DiscLaw>{law, pair}.push(touch, turn_of(k), memory, just_begun, 1e-6);
            CHECK(one.normal == full.normal);
            CHECK(one.shear == full.shear);
            CHECK(one.memory.kept == full.memory.kept);
            CHECK(one.lost_sliding == full.lost_sliding);
            CHECK(one.lost_normal_damping == full.lost_normal_damping);
            CHECK(full.torque == 0);
        }
    };
    compare(CundallStrack(pair, false, true));
    compare(HertzDiscs<Mindlin>(pair, true));
}

} // namespace test_additions
