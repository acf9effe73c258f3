#include "about.h"
#include "contact/law.h"

#include <array>
#include <cmath>
#include <cstring>
#include <doctest/doctest.h>
#include <numbers>

namespace test_laws {

using namespace tumble;
using namespace tumble::contact;
using tumble::test::about;

namespace {

using Vec = Vec3<double>;
using TUMBLE_ISA::Pack;

const Material glass{"glass", 2500, 7e10, 0.24};
const Material lining{"lining", 1200, 2.5e7, 0.45};

PairConstants glass_on_glass(double restitution, double friction) {
    return derive(glass, glass, {restitution, friction, 2e5, 1.5e5});
}

Touch<double> touch(double overlap, Vec velocity) {
    return {overlap, {1, 0, 0}, velocity, 2e-3, 5e-5, 1};
}

constexpr double dt = 1e-7; // s
const Memory<double> fresh{{0, 0, 0}, 0};

} // namespace

TEST_CASE("the effective moduli of two equal materials are E / 2(1 - nu^2) and G / 2(2 - nu)") {
    const PairConstants pair = glass_on_glass(0.5, 0.3);
    const double shear_modulus = 7e10 / (2 * (1 + 0.24));
    CHECK(pair.E_eff == about(7e10 / (2 * (1 - 0.24 * 0.24)), 1e-14));
    CHECK(pair.G_eff == about(shear_modulus / (2 * (2 - 0.24)), 1e-14));
}

TEST_CASE("of two unlike materials the soft one gives way, and the order does not matter") {
    const PairConstants one = derive(glass, lining, {0.5, 0.3, 0, 0});
    const PairConstants other = derive(lining, glass, {0.5, 0.3, 0, 0});
    CHECK(one.E_eff == other.E_eff);
    CHECK(one.G_eff == other.G_eff);
    CHECK(one.E_eff == about(2.5e7 / (1 - 0.45 * 0.45), 1e-3));
}

TEST_CASE("damping is 0 for an elastic pair, 1 for restitution 0, and 1/sqrt(2) where ln e is -pi") {
    CHECK(glass_on_glass(1, 0).damping == 0);
    CHECK(glass_on_glass(0, 0).damping == 1);
    CHECK(glass_on_glass(std::exp(-std::numbers::pi), 0).damping == about(std::sqrt(0.5), 1e-14));
}

TEST_CASE("Hertz' force is 4/3 E* sqrt(R*) d^1.5, and the energy it stores is the force's integral over the overlap") {
    const PairConstants pair = glass_on_glass(1, 0);
    const auto at = [&](double overlap) { return Hertz::push(touch(overlap, {0, 0, 0}), 0.0, pair); };
    for (const double d : {1e-9, 1e-6, 3e-5}) {
        CHECK(at(d).elastic == about(4.0 / 3 * pair.E_eff * std::sqrt(2e-3) * std::pow(d, 1.5)));
        const double step = 1e-4 * d;
        CHECK((at(d + step).stored - at(d - step).stored) / (2 * step) == about(at(d).elastic, 1e-7));
    }
}

TEST_CASE("the linear force is k d, its energy k d^2 / 2, its dashpot 2 beta sqrt(k m)") {
    const PairConstants pair = glass_on_glass(0.3, 0);
    const auto push = LinearNormal::push(touch(1e-5, {-0.2, 0, 0}), -0.2, pair);
    CHECK(push.elastic == about(2e5 * 1e-5));
    CHECK(push.stored == about(0.5 * 2e5 * 1e-10));
    CHECK(push.viscous == about(0.2 * 2 * pair.damping * std::sqrt(2e5 * 5e-5)));
}

TEST_CASE("at the end of a rebound the dashpot pulls, unless limit_force is set") {
    const PairConstants pair = glass_on_glass(0.2, 0);
    const Touch<double> parting = touch(1e-9, {1, 0, 0});
    CHECK(Law<Hertz, NoTangential>{false}.push(parting, pair, fresh, dt).force.x < 0);
    CHECK(Law<Hertz, NoTangential>{true}.push(parting, pair, fresh, dt).force.x == 0);
    const Touch<double> meeting = touch(1e-6, {-1, 0, 0});
    CHECK(Law<Hertz, NoTangential>{true}.push(meeting, pair, fresh, dt).force.x ==
          Law<Hertz, NoTangential>{false}.push(meeting, pair, fresh, dt).force.x);
}

TEST_CASE("Mindlin's spring has the stiffness 8 G* sqrt(R* d) and holds while it stays below mu F_n") {
    const PairConstants pair = glass_on_glass(1, 0.5);
    const Vec slip{0, 0.01, 0};
    const auto push = Law<Hertz, Mindlin>{}.push(touch(1e-6, slip), pair, fresh, dt);
    const double stiffness = 8 * pair.G_eff * std::sqrt(2e-3 * 1e-6);
    CHECK(push.force.y == about(-stiffness * 0.01 * dt));
    CHECK(push.memory.spring.y == about(0.01 * dt));
    CHECK(push.memory.energy == about(0.5 * stiffness * std::pow(0.01 * dt, 2)));
    CHECK(push.lost_sliding == 0);
}

TEST_CASE("a contact that slides pushes with mu |F_n| against the slip and keeps the spring that this stretches") {
    const PairConstants pair = glass_on_glass(1, 0.5);
    const Vec slip{0, 30, -40};
    const auto push = Law<Hertz, Mindlin>{}.push(touch(1e-6, slip), pair, fresh, dt);
    const double limit = 0.5 * push.force.x;
    const double stiffness = 8 * pair.G_eff * std::sqrt(2e-3 * 1e-6);
    REQUIRE(stiffness * 50 * dt > limit);
    CHECK(push.force.y == about(-0.6 * limit));
    CHECK(push.force.z == about(0.8 * limit));
    CHECK(std::sqrt(dot(push.memory.spring, push.memory.spring)) == about(limit / stiffness));
    // Once at the limit, the whole way slipped in a step, times the force; in the step that reaches it, what is not
    // left in the spring, times the mean of the forces before and after.
    CHECK(push.lost_sliding == about(0.5 * limit * (50 * dt - limit / stiffness)));
    const auto next = Law<Hertz, Mindlin>{}.push(touch(1e-6, slip), pair, push.memory, dt);
    CHECK(next.lost_sliding == about(limit * 50 * dt));
}

TEST_CASE("what of the spring stands along the new normal is dropped, and its energy booked as lost with history") {
    const PairConstants pair = glass_on_glass(1, 10);
    const double stiffness = 8 * pair.G_eff * std::sqrt(2e-3 * 1e-6);
    const Memory<double> tilted{{3e-9, 4e-9, 0}, 0.5 * stiffness * 25e-18};
    const auto push = Law<Hertz, Mindlin>{}.push(touch(1e-6, {0, 0, 0}), pair, tilted, dt);
    CHECK(push.memory.spring.x == 0);
    CHECK(push.memory.spring.y == about(4e-9));
    CHECK(push.lost_history == about(0.5 * stiffness * 9e-18));
}

TEST_CASE("the share of damping scales both dashpots and no spring") {
    const PairConstants pair = glass_on_glass(0.3, 10);
    Touch<double> whole = touch(1e-6, {-0.1, 0.1, 0});
    Touch<double> shared = whole;
    shared.damping_share = 0.5;
    const Law<Hertz, Mindlin> law;
    const auto elastic = law.push(whole, glass_on_glass(1, 10), fresh, dt).force;
    const auto one = law.push(whole, pair, fresh, dt).force - elastic;
    const auto half = law.push(shared, pair, fresh, dt).force - elastic;
    CHECK(half.x == about(0.5 * one.x));
    CHECK(half.y == about(0.5 * one.y));
}

TEST_CASE_TEMPLATE("eight contacts at once give each the very bits of one alone", ThisLaw, Law<Hertz, Mindlin>,
                   Law<Hertz, NoTangential>, Law<LinearNormal, LinearTangential>) {
    const PairConstants pair = glass_on_glass(0.4, 0.3);
    std::array<Touch<double>, 8> alone;
    Touch<Pack> together;
    const auto lane_of = [](Pack& pack, int lane, double value) { pack.v[lane] = value; };
    for (int k = 0; k < 8; ++k) {
        alone[static_cast<std::size_t>(k)] = touch(1e-7 * (k + 1), {0.1 * k - 0.4, 0.3 * k, -0.05 * k * k});
        const Touch<double>& one = alone[static_cast<std::size_t>(k)];
        lane_of(together.overlap, k, one.overlap);
        lane_of(together.normal.x, k, one.normal.x);
        lane_of(together.normal.y, k, one.normal.y);
        lane_of(together.normal.z, k, one.normal.z);
        lane_of(together.velocity.x, k, one.velocity.x);
        lane_of(together.velocity.y, k, one.velocity.y);
        lane_of(together.velocity.z, k, one.velocity.z);
        lane_of(together.radius, k, one.radius);
        lane_of(together.mass, k, one.mass);
        lane_of(together.damping_share, k, one.damping_share);
    }
    const Pack none(0.0);
    const ThisLaw law{};
    const Push<Pack> eight = law.push(together, pair, Memory<Pack>{{none, none, none}, none}, Pack(dt));
    for (int k = 0; k < 8; ++k) {
        const Push<double> one = law.push(alone[static_cast<std::size_t>(k)], pair, fresh, dt);
        CHECK(eight.force.x.v[k] == one.force.x);
        CHECK(eight.force.y.v[k] == one.force.y);
        CHECK(eight.force.z.v[k] == one.force.z);
        CHECK(eight.memory.energy.v[k] == one.memory.energy);
        CHECK(eight.lost_sliding.v[k] == one.lost_sliding);
        CHECK(eight.lost_normal_damping.v[k] == one.lost_normal_damping);
    }
}

} // namespace test_laws
