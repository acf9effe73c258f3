#include "setups.h"

#include <cmath>

namespace blind {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double plate_frequency = 12.65; // Hz

/// Four drops from different heights; with `more` two of a light ball, and a clock in the picture.
void draw_drops(Setup& setup, bool more, Random& random) {
    for (const double height : {0.5, 0.8, 1.1, 1.5})
        setup.trials.push_back({.height = std::round(1000 * height * random.uniform(0.9, 1.1)) / 1000});
    if (more) {
        setup.trials.push_back({.height = std::round(1000 * random.uniform(0.7, 0.9)) / 1000, .mass = 0.25});
        setup.trials.push_back({.height = std::round(1000 * random.uniform(1.3, 1.5)) / 1000, .mass = 0.25});
    }
    setup.rate_hz = std::round(random.uniform(96, 144));
}

/// Two throws each way on the level; with `more` one each way up a slope, and a clock in the picture.
void draw_throws(Setup& setup, bool more, Random& random) {
    for (const double speed : {2.5, -2.5, 1.4, -1.4})
        setup.trials.push_back({.speed = std::round(100 * speed * random.uniform(0.9, 1.1)) / 100});
    if (more)
        for (const double way : {1.0, -1.0})
            setup.trials.push_back(
                {.speed = way * std::round(100 * random.uniform(1.8, 2.2)) / 100, .slope = -3 * way});
    setup.rate_hz = std::round(random.uniform(48, 72));
    setup.duration = 2;
}

/// Three slopes, each to either side; with `more` a steeper one, and a clock in the picture.
void draw_slides(Setup& setup, bool more, Random& random) {
    for (const double slope : {18.0, -18.0, 24.0, -24.0, 30.0, -30.0})
        setup.trials.push_back({.slope = std::round(10 * slope * random.uniform(0.97, 1.03)) / 10});
    if (more)
        for (const double slope : {36.0, -36.0})
            setup.trials.push_back({.slope = std::round(10 * slope * random.uniform(0.97, 1.03)) / 10});
    setup.rate_hz = std::round(random.uniform(80, 120));
    setup.duration = 0.8;
}

/// Rolling, twice each way; with `more` two slower ones, and a clock in the picture.
void draw_rolls(Setup& setup, bool more, Random& random) {
    for (const double speed : {1.0, -1.0, 0.5, -0.5})
        setup.trials.push_back({.speed = std::round(100 * speed * random.uniform(0.9, 1.1)) / 100});
    if (more)
        for (const double speed : {0.25, -0.25})
            setup.trials.push_back({.speed = std::round(100 * speed * random.uniform(0.9, 1.1)) / 100});
    setup.rate_hz = std::round(random.uniform(48, 72));
    setup.duration = 3;
}

/// Six angles to the normal of what strikes at 2.4 m/s, sticking to sliding, to either side by turns; with `more` two
/// from higher up, and a clock in the picture.
void draw_oblique(Setup& setup, bool more, Random& random) {
    for (const double speed : {0.9, -1.7, 2.9, -4.2, 6.0, -8.2})
        setup.trials.push_back({.height = std::round(1000 * random.uniform(0.28, 0.32)) / 1000,
                                .speed = std::round(100 * speed * random.uniform(0.97, 1.03)) / 100});
    if (more)
        for (const double speed : {2.0, -5.0})
            setup.trials.push_back({.height = std::round(1000 * random.uniform(0.4, 0.42)) / 1000,
                                    .speed = std::round(100 * speed * random.uniform(0.97, 1.03)) / 100});
    setup.rate_hz = std::round(random.uniform(96, 144));
    setup.duration = 0.6;
}

/// Two spins each way; with `more` a quicker one each way, and a clock in the picture.
void draw_spins(Setup& setup, bool more, Random& random) {
    for (const double spin : {40.0, -40.0, 20.0, -20.0})
        setup.trials.push_back({.spin = std::round(10 * spin * random.uniform(0.9, 1.1)) / 10});
    if (more)
        for (const double spin : {60.0, -60.0})
            setup.trials.push_back({.spin = std::round(10 * spin * random.uniform(0.9, 1.1)) / 10});
    setup.rate_hz = std::round(random.uniform(160, 240));
    setup.duration = 0.3;
}

/// Four accelerations of the plate at which flights repeat, 1.3 to 3 g: between 2 and 2.5 g they are chaotic. With
/// `more` two others, and a clock in the picture.
void draw_plates(Setup& setup, bool more, Random& random) {
    const auto add = [&](double g) {
        const double pace = 2 * pi * plate_frequency;
        setup.trials.push_back(
            {.shaken = std::round(1e7 * g * random.uniform(0.99, 1.01) * 9.81 / (pace * pace)) / 1e7});
    };
    for (const double g : {1.3, 1.6, 2.9, 3.0})
        add(g);
    if (more)
        for (const double g : {1.45, 1.75})
            add(g);
    setup.rate_hz = std::round(random.uniform(96, 144));
    setup.duration = 1;
}

} // namespace

Setup draw_setup(Bench bench, bool more, Random& random) {
    Setup setup;
    setup.bench = bench;
    constexpr void (*draw[])(Setup&, bool, Random&) = {draw_drops,   draw_throws, draw_slides, draw_rolls,
                                                       draw_oblique, draw_spins,  draw_plates};
    draw[static_cast<int>(bench)](setup, more, random);
    const double usual = bench == Bench::spin ? 0.2 : bench == Bench::plate ? 5e-4 : 2e-3;
    setup.sigma = std::round(1e6 * random.uniform(0.7, 1.3) * usual) / 1e6;
    setup.clock = more;
    return setup;
}

Truth baseline(Bench bench) {
    const auto modulus = [](double soft) { return 1 / ((1 - 0.3 * 0.3) / soft + (1 - 0.3 * 0.3) / 1e10); };
    const auto shear = [](double soft) { return 1 / ((2 - 0.3) * 2.6 / soft + (2 - 0.3) * 2.6 / 1e10); };
    Truth truth;
    truth.ball = {.radius = 0.12, .mass = 0.6, .modulus = modulus(1.27e6), .restitution = 0.8};
    truth.lane = {.radius = 0.05, .mass = 0.5, .modulus = modulus(2e7), .friction = 0.2, .fast_friction = 0.2};
    if (bench == Bench::oblique)
        truth.ball = {.radius = 0.05, .mass = 0.5, .modulus = modulus(2e7), .shear = shear(2e7), .restitution = 0.5};
    if (bench == Bench::plate)
        truth.ball = {.radius = 0.01,
                      .mass = 1200 * 4.0 / 3 * pi * 1e-6,
                      .modulus = 1 / ((1 - 0.3 * 0.3) / 1e7 + (1 - 0.3 * 0.3) / 2e11),
                      .restitution = 0.3,
                      .shaken = 1,
                      .shaken_at = plate_frequency};
    if (bench == Bench::slope ||
        bench == Bench::spin) // air takes its three feet of 5 mm for one sphere of their volume
        truth.lane = {.radius = 5e-3 * std::cbrt(3.0),
                      .mass = 1200 * 3 * 4.0 / 3 * pi * 5e-3 * 5e-3 * 5e-3,
                      .friction = 0.27,
                      .fast_friction = 0.27};
    return truth;
}

} // namespace blind
