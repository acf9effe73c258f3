#include "about.h"
#include "contact/cundall_strack.h"
#include "contact/hertz_discs.h"
#include "contact/material.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

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

/// Drags a contact along x at a fixed overlap, forth and back; the work that goes in, J, and the largest shear, N.
template <class Law> std::pair<double, double> drag(const Law& law, double overlap, double way) {
    const double dt = 1e-5, speed = 0.1;
    DiscMemory<double> memory{0, 0};
    double work = 0, largest = 0, place = 0;
    for (const double end : {way, -way, 0.0}) {
        const double rate = end > place ? speed : -speed;
        while ((end - place) * rate > 0) {
            const auto push = law.push(DiscTouch<double>{overlap, 0, rate, 0.05, 1}, memory, dt);
            memory = push.memory;
            work += push.shear * rate * dt;
            largest = std::max(largest, std::abs(push.memory.shear));
            place += rate * dt;
        }
    }
    return {work, largest};
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
    const CundallStrack linear(pair_of(1e5, 0.7, 0.8, 0.3), true, true);
    const auto [work, largest] = drag(linear, 1e-3, 5e-3);
    CHECK(work > 0);
    CHECK(largest <= 0.3 * 100 * (1 + 1e-12));
    PairProperties glass;
    glass.restitution = 0.8;
    glass.friction = 0.3;
    const Material material{"glass", 2500, 1e8, 0.25};
    const HertzDiscs<Mindlin> hertz(derive(material, material, glass), true);
    CHECK(drag(hertz, 1e-4, 5e-4).first > 0);
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
