#include "about.h"
#include "contact/cundall_strack.h"
#include "contact/hertz_discs.h"
#include "contact/material.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_disc_laws {

using namespace tumble::contact;
using tumble::test::about;

namespace {

PairConstants pair_of(double k_n, double ratio, double e, double mu, double cohesion = 0) {
    PairProperties pair;
    pair.normal_stiffness = k_n;
    pair.stiffness_ratio = ratio;
    pair.restitution = e;
    pair.friction = mu;
    pair.cohesion = cohesion;
    return derive({"stone", 1000, 0, 0}, {"stone", 1000, 0, 0}, pair);
}

struct Dragged {
    double work = 0;                           // J, put in along the shear, trapezoidal rule
    double lost_sliding = 0, lost_damping = 0; // J, as the law books them
    double stored = 0;                         // J, at the end
    double largest = 0;                        // N, of the spring's shear force
    [[nodiscard]] double booked() const { return lost_sliding + lost_damping + stored; }
};

/// Drags a contact along x at a fixed overlap, forth and back.
template <class Law> Dragged drag(const Law& law, double overlap, double way) {
    const double dt = 1e-6, speed = 0.1;
    // Heavy, so that half a step's force does not change the rate, which the rig prescribes.
    const double mass = 10;
    DiscMemory<double> memory{0, 0};
    Dragged seen;
    double place = 0, before = 0;
    for (const double end : {way, -way, 0.0}) {
        const double rate = end > place ? speed : -speed;
        for (auto left = std::llround((end - place) / (rate * dt)); left > 0; --left) {
            const auto push = law.push(DiscTouch<double>{overlap, 0, rate, 0.05, mass}, memory, dt);
            memory = push.memory;
            seen.work += 0.5 * (before + push.shear) * rate * dt;
            seen.lost_sliding += push.lost_sliding;
            seen.lost_damping += push.lost_shear_damping;
            seen.largest = std::max(seen.largest, std::abs(push.memory.force()));
            before = push.shear;
        }
        place = end;
    }
    seen.stored = memory.energy;
    return seen;
}

/// Slides at 1 m/s while the overlap rises and falls like half a sine of 0.1 s; what the law books as lost, J.
template <class Law> double lost_while_the_limit_moves(const Law& law, double depth, int steps) {
    const double dt = 0.1 / steps;
    DiscMemory<double> memory{0, 0};
    double lost = 0;
    for (int k = 1; k <= steps; ++k) {
        const double overlap = depth * std::max(0.0, std::sin(std::numbers::pi * k / steps));
        const auto push = law.push(DiscTouch<double>{overlap, 0, 1, 0.05, 1}, memory, dt);
        memory = push.memory;
        lost += push.lost_sliding + push.lost_history;
    }
    return lost;
}

} // namespace

TEST_CASE("increments of the shear force add up until Coulomb's limit F_n tan(phi) + c holds them") {
    const CundallStrack law(pair_of(1000, 0.5, 1, 0.4, 0.25), false, true);
    DiscMemory<double> memory{0, 0};
    const double overlap = 0.01, dt = 0.01, rate = 0.05; // F_n = 10 N, limit 4.25 N, 0.25 N a step
    for (int step = 1; step <= 30; ++step) {
        const auto push = law.push(DiscTouch<double>{overlap, 0, rate, 0.05, 1}, memory, dt);
        memory = push.memory;
        CHECK(push.normal == about(10));
        CHECK(push.shear == about(std::min(0.25 * step, 4.25)));
    }
    CHECK(memory.energy == about(4.25 * 4.25 / (2 * 500)));
}

TEST_CASE("a loading loop never makes energy, and what it takes is what the law books") {
    // The dashpot's force jumps where the rig turns, which the trapezoidal rule sees as a slope: a step's part of it.
    const CundallStrack linear(pair_of(1e5, 0.7, 0.8, 0.3), true, true);
    const Dragged soft = drag(linear, 1e-3, 5e-3);
    CHECK(soft.largest == about(0.3 * 100, 1e-9));
    // Slides from limit / k_s = 30 N / 7e4 N/m on, twice that after each turn.
    const double yield = 30 / 7e4;
    CHECK(soft.lost_sliding == about(30 * (5e-3 - yield + 10e-3 - 2 * yield + 5e-3 - 2 * yield), 1e-3));
    CHECK(soft.lost_damping > 0);
    CHECK(soft.booked() == about(soft.work, 2e-3));
    PairProperties glass;
    glass.restitution = 0.8;
    glass.friction = 0.3;
    const Material material{"glass", 2500, 1e8, 0.25};
    const HertzDiscs<Mindlin> hertz(derive(material, material, glass), true);
    const Dragged sphere = drag(hertz, 1e-4, 5e-4);
    CHECK(sphere.lost_sliding > 0);
    CHECK(sphere.booked() == about(sphere.work, 2e-3));
}

TEST_CASE("the book of sliding is second order in the step also where the normal force rises and falls") {
    // Nothing is stored at the end: mu k_n times the integral of the overlap along the way is lost.
    const CundallStrack linear(pair_of(1e5, 0.7, 1, 0.3), true, true);
    const double all = 0.3 * 1e5 * 1e-3 * 0.2 / std::numbers::pi;
    const double coarse = std::abs(lost_while_the_limit_moves(linear, 1e-3, 100) - all);
    const double fine = std::abs(lost_while_the_limit_moves(linear, 1e-3, 1000) - all);
    CHECK(coarse < 1e-4 * all); // the trapezoidal rule's part, (pi / 100)^2 / 12
    CHECK(fine < coarse / 80);
    PairProperties glass;
    glass.restitution = 1;
    glass.friction = 0.3;
    const Material material{"glass", 2500, 1e8, 0.25};
    const HertzDiscs<Mindlin> hertz(derive(material, material, glass), true);
    const double limit = lost_while_the_limit_moves(hertz, 1e-4, 100000);
    const double rough = std::abs(lost_while_the_limit_moves(hertz, 1e-4, 100) - limit);
    CHECK(rough < 1e-3 * limit);
    CHECK(std::abs(lost_while_the_limit_moves(hertz, 1e-4, 1000) - limit) < rough / 50);
}

TEST_CASE("without shear law nothing rubs") {
    const CundallStrack law(pair_of(1000, 0.5, 1, 0.4), false, false);
    const auto push = law.push(DiscTouch<double>{0.01, 0, 3, 0.05, 1}, DiscMemory<double>{0, 0}, 0.01);
    CHECK(push.shear == 0);
    CHECK(push.memory.energy == 0);
}

TEST_CASE("a contact time sets the stiffness: m* (pi^2 + ln^2 e) / t^2") {
    PairProperties pair;
    pair.restitution = 0.5;
    pair.contact_time = 0.01;
    pair.stiffness_ratio = 1;
    const CundallStrack law(derive({"a", 1, 0, 0}, {"a", 1, 0, 0}, pair), false, true);
    const double ln = std::log(0.5);
    const double k = 3 * (std::numbers::pi * std::numbers::pi + ln * ln) / 1e-4;
    CHECK(law.push(DiscTouch<double>{0.01, 0, 0, 0.05, 3}, DiscMemory<double>{0, 0}, 1e-4).normal == about(0.01 * k));
}

TEST_CASE("a normal force that may not pull does not") {
    const DiscTouch<double> leaving{1e-4, -10, 0, 0.05, 1};
    CHECK(CundallStrack(pair_of(1000, 1, 0.2, 0), false, true).push(leaving, DiscMemory<double>{0, 0}, 1e-4).normal <
          0);
    CHECK(CundallStrack(pair_of(1000, 1, 0.2, 0), true, true).push(leaving, DiscMemory<double>{0, 0}, 1e-4).normal ==
          0);
}

} // namespace test_disc_laws
