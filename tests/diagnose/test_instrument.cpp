#include "about.h"
#include "diagnose/cause.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_instrument {

using namespace tumble::diagnose;
using tumble::test::about;

namespace {

Signal parabola() {
    Signal signal;
    for (int k = 0; k <= 1000; ++k) {
        const double t = 1e-3 * k;
        signal.time.push_back(t);
        signal.value.push_back(1 - 4.9 * t * t);
    }
    return signal;
}

} // namespace

TEST_CASE("a signal is read exactly between its rows where it is a cubic") {
    const Signal signal = parabola();
    CHECK(signal.at(0.12345) == about(1 - 4.9 * 0.12345 * 0.12345, 1e-12));
    CHECK(signal.rate_at(0.3) == about(-9.8 * 0.3, 1e-9));
    CHECK(signal.at(-1) == 1);
}

TEST_CASE("a turn between two rows, as an impact makes it, stays sharp wherever between them it lies") {
    for (const double meet : {0.5, 0.5 + 1e-7, 0.50037, 0.5009999}) {
        const auto truth = [&](double t) {
            return t < meet ? 4.9 * (meet * meet - t * t) : 3 * (t - meet) - 4.9 * (t - meet) * (t - meet);
        };
        Signal signal;
        for (int k = 0; k <= 1000; ++k) {
            signal.time.push_back(1e-3 * k);
            signal.value.push_back(truth(1e-3 * k));
        }
        for (int k = -40; k <= 40; ++k) {
            const double t = meet + 1.3e-4 * k;
            CHECK(std::abs(signal.at(t) - truth(t)) < 1e-10);
        }
    }
}

TEST_CASE("a low pass lags a ramp by its time constant") {
    Signal ramp;
    for (int k = 0; k <= 1000; ++k) {
        ramp.time.push_back(1e-3 * k);
        ramp.value.push_back(2e-3 * k);
    }
    // y' = (x - y) / tau settles to x - tau x'.
    CHECK(ramp.low_passed(0.05, 0).at(0.9) == about(2 * (0.9 - 0.05), 1e-6));
}

TEST_CASE("a perfect instrument shows the signal bit for bit, and so does every cause at its null value") {
    const Signal signal = parabola();
    const std::vector<double> times{0.1, 0.2, 0.7};
    const std::vector<double> shown = seen_through({}, signal, times);
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(shown[k] == signal.at(times[k]));
    for (const Cause& cause : all_causes()) {
        if (cause.physical())
            continue;
        Instrument instrument;
        cause.distort(instrument, 0);
        CHECK(seen_through(instrument, signal, times) == shown);
    }
}

TEST_CASE("a high pass forgets what is constant from the record's beginning on, and hardly when it is slow") {
    Signal rest;
    for (int k = 0; k <= 1000; ++k) {
        rest.time.push_back(1e-3 * k);
        rest.value.push_back(2);
    }
    const std::vector<double> times{0.0, 0.5, 1.0};
    const std::vector<double> shown = seen_through({.high_pass = 2}, rest, times);
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(shown[k] == about(2 * std::exp(-2 * times[k]), 1e-9));
    CHECK(seen_through({.high_pass = 1e-9}, rest, times)[2] == about(2, 1e-8));
}

TEST_CASE("a clock that starts late and runs fast shows an earlier time") {
    const Signal signal = parabola();
    const Instrument late{.clock_offset = 0.1, .clock_rate = 0.25};
    CHECK(seen_through(late, signal, std::vector{0.6})[0] == about(signal.at(0.4)));
    CHECK(clock_seen_through(late, std::vector{0.6})[0] == about(0.4));
}

TEST_CASE("every cause of the library is whole: a name, a fingerprint, a range around its null, one way to act") {
    for (const Cause& cause : all_causes()) {
        CAPTURE(cause.id);
        CHECK(cause.lo <= 0);
        CHECK(cause.hi > 0);
        CHECK(cause.typical > 0);
        CHECK(cause.typical < cause.hi);
        CHECK((cause.extend != nullptr) != (cause.distort != nullptr));
        CHECK(!cause.name.empty());
        CHECK(!cause.look.empty());
        CHECK(!cause.keys.empty());
        CHECK(choose_causes({cause.id})->size() == 1);
    }
}

TEST_CASE("a cause that does not exist is refused with the nearest one") {
    const auto chosen = choose_causes({"ins.gian"});
    REQUIRE(!chosen);
    CHECK(chosen.problems()[0].fix.find("ins.gain") != std::string::npos);
    CHECK(choose_causes({"clock"})->size() == 2); // a family
}

} // namespace test_instrument
