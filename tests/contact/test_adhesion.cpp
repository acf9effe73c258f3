#include "about.h"
#include "contact/full_law.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <vector>

namespace test_adhesion {

using namespace tumble;
using namespace tumble::contact;
using tumble::test::about;
using TUMBLE_ISA::Pack;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double dt = 1e-8;     // s
constexpr double radius = 5e-4; // m, R*
constexpr double work = 0.1;    // J/m2
const Material soft{"soft", 1200, 5e6, 0.3};
const Memory<double> fresh{{0, 0, 0}, 0};

PairConstants sticky(AdhesionLaw law, double friction = 0) {
    PairProperties pair;
    pair.restitution = 1;
    pair.friction = friction;
    pair.work_of_adhesion = work;
    pair.cohesion_energy = 2e4;
    return derive(soft, soft, pair, {RollingLaw::none, law});
}

double E_eff() {
    return 5e6 / (2 * (1 - 0.3 * 0.3));
}

/// m, the scale of JKR's overlaps: a^2 / R at the tear.
double tear_scale() {
    return std::pow(pi * work * radius * radius / (8 * E_eff()), 2.0 / 3) / radius;
}

struct Pull {
    double force = 0, stored = 0, torn = 0; // N, J, J lost to tearing
    bool held = false;
};

Touch<double> touch_of(int k) {
    return {1e-7 * (k + 1), {0.6, 0, 0.8}, {0.1 * k - 0.4, 0.3 * k, -0.05 * k * k}, radius, 5e-6, 1};
}

bool same(const Vec3<double>& a, const Vec3<double>& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Carries two grains along the normal through these overlaps (m), slowly; `each` sees overlap and Pull.
template <class Each> void drag(const PairConstants& pair, const std::vector<double>& corners, Each&& each) {
    constexpr int steps = 4000; // a leg
    Further<double> further{};
    double at = corners.front();
    for (std::size_t leg = 1; leg < corners.size(); ++leg) {
        const double step = (corners[leg] - at) / steps;
        for (int k = 0; k < steps; ++k) {
            at += step;
            const Touch<double> touch{at, {1, 0, 0}, {0, 0, 0}, radius, 1e-6, 1};
            const auto push = FullLaw<Hertz, Mindlin>{}.push(touch, {}, pair, fresh, further, dt);
            further = push.further;
            each(at, Pull{push.force.x, push.stored_normal, push.lost_adhesion, push.holds > 0});
        }
    }
}

double hertz(double overlap) {
    return overlap > 0 ? 4.0 / 3 * E_eff() * std::sqrt(radius) * std::pow(overlap, 1.5) : 0;
}

} // namespace

TEST_CASE("JKR: at an overlap the contact radius solves both of Johnson, Kendall and Roberts' equations") {
    const PairConstants pair = sticky(AdhesionLaw::jkr);
    for (const double scaled : {-2.999, -1.5, -0.1, 0.0, 0.5, 10.0, 1e4, 1e6}) {
        CAPTURE(scaled);
        const double overlap = scaled * tear_scale();
        const Touch<double> touch{overlap, {1, 0, 0}, {0, 0, 0}, radius, 1e-6, 1};
        const auto push = Jkr::push(touch, 0.0, pair);
        const double a = push.stiffness;
        const double solved = a * a / radius - std::sqrt(2 * pi * work * a / E_eff());
        CHECK(std::abs(solved - overlap) < 1e-9 * (tear_scale() + std::abs(overlap)));
        CHECK(push.elastic ==
              about(4 * E_eff() * a * a * a / (3 * radius) - std::sqrt(8 * pi * work * E_eff() * a * a * a), 1e-9));
    }
}

TEST_CASE(
    "JKR: pulled off, two spheres hold 3/2 pi w R*, and let go at -3 (pi w / 8 E*)^(2/3) R*^(1/3) with 5/9 of it") {
    double strongest = 0, last_gap = 0, last_force = 0, torn = 0, work_done = 0, before = 0, place = 0;
    const double far = 5 * tear_scale();
    drag(sticky(AdhesionLaw::jkr), {-far, far, -far}, [&](double overlap, const Pull& pull) {
        work_done -= 0.5 * (before + pull.force) * (overlap - place) * (place != 0);
        before = pull.force;
        place = overlap;
        torn += pull.torn;
        if (!pull.held)
            return;
        strongest = std::max(strongest, -pull.force);
        last_gap = -overlap;
        last_force = -pull.force;
    });
    const double pull_off = 1.5 * pi * work * radius;
    CHECK(strongest == about(pull_off, 1e-4));
    CHECK(last_gap == about(3 * tear_scale(), 2e-3));
    CHECK(last_force == about(5.0 / 9 * pull_off, 0.05)); // the force falls steeply there
    // What a contact costs that is made at overlap 0 and torn, 7.09 (w^5 R^4 / E^2)^(1/3) (Thornton and Ning 1998).
    const double cost = 7.09 * std::cbrt(std::pow(work, 5) * std::pow(radius, 4) / std::pow(E_eff(), 2));
    CHECK(torn == about(cost, 5e-3));
    CHECK(-work_done == about(cost, 1e-2));
}

TEST_CASE("JKR: a contact forms at overlap 0, with 8/9 of the pull-off force, and not before") {
    bool first = true;
    drag(sticky(AdhesionLaw::jkr), {-4 * tear_scale(), tear_scale()}, [&](double overlap, const Pull& pull) {
        CHECK(pull.held == (overlap > 0));
        if (!pull.held)
            CHECK(pull.force == 0);
        if (pull.held && first) {
            CHECK(-pull.force == about(8.0 / 9 * 1.5 * pi * work * radius, 2e-3));
            first = false;
        }
    });
    CHECK(!first);
}

TEST_CASE("JKR: far beyond the reach of adhesion the force is that of Hertz") {
    const double deep = 1e7 * tear_scale();
    const Touch<double> touch{deep, {1, 0, 0}, {0, 0, 0}, radius, 1e-6, 1};
    CHECK(Jkr::push(touch, 0.0, sticky(AdhesionLaw::jkr)).elastic == about(hertz(deep), 1e-3));
}

TEST_CASE("DMT: Hertz' force less 2 pi w R*, and that is the pull-off force") {
    double strongest = 0;
    const double little = 1e-4 * tear_scale();
    drag(sticky(AdhesionLaw::dmt), {little, 5 * tear_scale(), little}, [&](double overlap, const Pull& pull) {
        CHECK(pull.force == about(hertz(overlap) - 2 * pi * work * radius, 1e-9));
        strongest = std::max(strongest, -pull.force);
    });
    CHECK(strongest == about(2 * pi * work * radius, 0.01));
}

TEST_CASE("SJKR: a pull of k 2 pi R* d, which gives a pull-off force of 2/3 pi^3 k^3 R*^2 / E*^2") {
    double strongest = 0;
    drag(sticky(AdhesionLaw::sjkr), {0, 1e-5, 0}, [&](double overlap, const Pull& pull) {
        if (overlap > 0)
            CHECK(pull.force == about(hertz(overlap) - 2e4 * 2 * pi * radius * overlap, 1e-9));
        strongest = std::max(strongest, -pull.force);
    });
    const double expected = 2.0 / 3 * std::pow(pi * 2e4, 3) * radius * radius / (E_eff() * E_eff());
    CHECK(strongest == about(expected, 1e-3));
}

TEST_CASE("the energy that an adhesive contact stores is the force's integral over the overlap") {
    for (const auto law : {AdhesionLaw::sjkr, AdhesionLaw::dmt, AdhesionLaw::jkr}) {
        CAPTURE(static_cast<int>(law));
        double place = 0, before = 0, sum = 0, start = 0, worst = 0, most = 0;
        drag(sticky(law), {tear_scale(), 10 * tear_scale()}, [&](double overlap, const Pull& pull) {
            if (place == 0)
                start = pull.stored;
            else
                sum += 0.5 * (before + pull.force) * (overlap - place);
            place = overlap;
            before = pull.force;
            worst = std::max(worst, std::abs(pull.stored - start - sum));
            most = std::max(most, std::abs(pull.stored));
        });
        CHECK(worst < 1e-5 * most);
    }
}

TEST_CASE("with limit_force the dashpot adds nothing to what adhesion pulls") {
    // Parting so fast that every dashpot would pull a hundred times as hard as the surfaces stick.
    for (const auto law : {AdhesionLaw::jkr, AdhesionLaw::dmt, AdhesionLaw::sjkr})
        for (const double scaled : {-2.5, -0.5, 0.5, 2.0, 20.0}) {
            if (scaled < 0 && law != AdhesionLaw::jkr)
                continue;
            CAPTURE(static_cast<int>(law));
            CAPTURE(scaled);
            PairConstants pair = sticky(law);
            pair.hertz_damping = 1e6;
            Touch<double> touch{scaled * tear_scale(), {1, 0, 0}, {0, 0, 0}, radius, 1e-6, 1};
            const Further<double> stuck{fresh, 1, 1, 0};
            const double at_rest = FullLaw<Hertz, Mindlin>{true}.push(touch, {}, pair, fresh, stuck, dt).force.x;
            const double expected = law == AdhesionLaw::jkr   ? std::min(Jkr::push(touch, 0.0, pair).elastic, 0.0)
                                    : law == AdhesionLaw::dmt ? -2 * pi * work * radius
                                                              : -2e4 * 2 * pi * radius * touch.overlap;
            touch.velocity = {10, 0, 0};
            const double parting = FullLaw<Hertz, Mindlin>{true}.push(touch, {}, pair, fresh, stuck, dt).force.x;
            CHECK(parting == about(expected, 1e-12));
            if (law != AdhesionLaw::sjkr) // the pull-off force is the most that they ever pull
                CHECK(parting >= -(law == AdhesionLaw::jkr ? 1.5 : 2.0) * pi * work * radius * (1 + 1e-12));
            CHECK(at_rest == about(FullLaw<Hertz, Mindlin>{}
                                       .push({scaled * tear_scale(), {1, 0, 0}, {0, 0, 0}, radius, 1e-6, 1}, {}, pair,
                                             fresh, stuck, dt)
                                       .force.x,
                                   1e-9));
        }
}

TEST_CASE("a parameter of 0 takes each adhesion law away, bit for bit") {
    PairProperties dry;
    dry.restitution = 0.5;
    dry.friction = 0.3;
    const PairConstants plain = derive(soft, soft, dry);
    for (const auto law : {AdhesionLaw::none, AdhesionLaw::sjkr, AdhesionLaw::dmt, AdhesionLaw::jkr}) {
        PairConstants zero = derive(soft, soft, dry, {RollingLaw::none, law});
        REQUIRE(zero.plain()); // so JKR, which has no contact radius without w, is not even asked
        if (law != AdhesionLaw::jkr)
            zero.adhesion = law;
        for (const bool limited : {false, true})
            for (int k = 0; k < 8; ++k) {
                const Touch<double> touch = touch_of(k);
                const auto one = Law<Hertz, Mindlin>{limited}.push(touch, plain, fresh, dt);
                const auto full = FullLaw<Hertz, Mindlin>{limited}.push(touch, {}, zero, fresh, Further<double>{}, dt);
                CHECK(same(one.force, full.force));
                CHECK(same(one.memory.spring, full.memory.spring));
                CHECK(one.memory.energy == full.memory.energy);
                CHECK(one.stored_normal == full.stored_normal);
                CHECK(one.lost_normal_damping == full.lost_normal_damping);
                CHECK(one.lost_tangential_damping == full.lost_tangential_damping);
                CHECK(one.lost_sliding == full.lost_sliding);
                CHECK(full.lost_adhesion == 0);
            }
    }
}

TEST_CASE("eight contacts that stick, touch or are torn give each the very bits of one alone") {
    for (const auto law : {AdhesionLaw::sjkr, AdhesionLaw::dmt, AdhesionLaw::jkr}) {
        CAPTURE(static_cast<int>(law));
        const PairConstants pair = sticky(law, 0.5);
        Touch<Pack> touch{};
        Further<Pack> further{};
        const auto touch_at = [&](int k) {
            Touch<double> one = touch_of(k);
            // Two gaps beyond the reach of a neck, two within it of which one never touched, four overlaps.
            constexpr double overlaps[] = {-3.5, -3.1, -2.9, -0.5, 0.0, 0.3, 4.0, 300.0};
            if (law == AdhesionLaw::jkr)
                one.overlap = overlaps[k] * tear_scale();
            return one;
        };
        const auto further_at = [](int k) { return Further<double>{fresh, 0.1 * k, k == 3 ? 0.0 : 1.0, 1e-9 * k}; };
        for (int k = 0; k < 8; ++k) {
            const Touch<double> one = touch_at(k);
            touch.overlap.v[k] = one.overlap;
            touch.normal.x.v[k] = one.normal.x;
            touch.normal.y.v[k] = one.normal.y;
            touch.normal.z.v[k] = one.normal.z;
            touch.velocity.x.v[k] = one.velocity.x;
            touch.velocity.y.v[k] = one.velocity.y;
            touch.velocity.z.v[k] = one.velocity.z;
            touch.radius.v[k] = one.radius;
            touch.mass.v[k] = one.mass;
            touch.damping_share.v[k] = one.damping_share;
            further.impact_speed.v[k] = further_at(k).impact_speed;
            further.bonded.v[k] = further_at(k).bonded;
            further.bond_energy.v[k] = further_at(k).bond_energy;
        }
        const auto eight = FullLaw<Hertz, Mindlin>{true}.push(touch, {}, pair, Memory<Pack>{}, further, Pack(dt));
        int holding = 0;
        for (int k = 0; k < 8; ++k) {
            CAPTURE(k);
            const auto one = FullLaw<Hertz, Mindlin>{true}.push(touch_at(k), {}, pair, fresh, further_at(k), dt);
            CHECK(eight.force.x.v[k] == one.force.x);
            CHECK(eight.force.y.v[k] == one.force.y);
            CHECK(eight.force.z.v[k] == one.force.z);
            CHECK(eight.memory.energy.v[k] == one.memory.energy);
            CHECK(eight.holds.v[k] == one.holds);
            CHECK(eight.stored_normal.v[k] == one.stored_normal);
            CHECK(eight.lost_adhesion.v[k] == one.lost_adhesion);
            CHECK(eight.further.bonded.v[k] == one.further.bonded);
            CHECK(eight.further.bond_energy.v[k] == one.further.bond_energy);
            holding += one.holds > 0 ? 1 : 0;
        }
        CHECK(holding == (law == AdhesionLaw::jkr ? 5 : 8)); // all from -2.9 on but the one that never touched
    }
}

TEST_CASE("rolling resistance feels what presses the surfaces together, as friction does") {
    // M = mu_r R* times Hertz' part beside the pull of DMT and SJKR, times F + 3 pi w R* (twice the pull-off force) of
    // JKR; the spin is all rolling.
    const Touch<double> pressed{20 * tear_scale(), {1, 0, 0}, {0, 0, 0}, radius, 1e-6, 1};
    const Turn<double> turn{{0, 0, 5}, 1e20};
    for (const auto law : {AdhesionLaw::sjkr, AdhesionLaw::dmt, AdhesionLaw::jkr}) {
        CAPTURE(static_cast<int>(law));
        PairConstants pair = sticky(law);
        pair.rolling = RollingLaw::cdt;
        pair.rolling_friction = 0.2;
        const auto push = FullLaw<Hertz, Mindlin>{}.push(pressed, turn, pair, fresh, Further<double>{}, dt);
        const double pressing =
            law == AdhesionLaw::jkr ? push.force.x + 3 * pi * work * radius : hertz(pressed.overlap);
        CHECK(push.torque.z == about(-0.2 * radius * pressing, 1e-9));
    }
}

TEST_CASE("friction is limited by what presses the surfaces together: the pull of adhesion counts in") {
    // Fast sliding at the overlap where Hertz' force and the pull are in balance: no net force, and yet friction.
    for (const auto law : {AdhesionLaw::dmt, AdhesionLaw::sjkr}) {
        const PairConstants pair = sticky(law, 0.5);
        const double overlap = law == AdhesionLaw::dmt
                                   ? std::pow(2 * pi * work * radius / (4.0 / 3 * E_eff() * std::sqrt(radius)), 2.0 / 3)
                                   : std::pow(2e4 * 2 * pi * radius / (4.0 / 3 * E_eff() * std::sqrt(radius)), 2);
        const Touch<double> touch{overlap, {1, 0, 0}, {0, 1e6, 0}, radius, 1e-6, 1};
        const auto push = FullLaw<Hertz, Mindlin>{}.push(touch, {}, pair, fresh, Further<double>{}, dt);
        CHECK(std::abs(push.force.x) < 1e-9 * hertz(overlap));
        CHECK(push.force.y == about(-0.5 * hertz(overlap)));
    }
    // JKR: the load and twice the pull-off force (Thornton 1991).
    const PairConstants pair = sticky(AdhesionLaw::jkr, 0.5);
    const Touch<double> touch{0, {1, 0, 0}, {0, 1e6, 0}, radius, 1e-6, 1};
    Touch<double> pressed = touch;
    pressed.overlap = 20 * tear_scale();
    const auto push = FullLaw<Hertz, Mindlin>{}.push(pressed, {}, pair, fresh, Further<double>{}, dt);
    CHECK(push.force.y == about(-0.5 * (push.force.x + 3 * pi * work * radius)));
}

} // namespace test_adhesion
