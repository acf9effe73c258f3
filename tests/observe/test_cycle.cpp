#include "about.h"
#include "base/rng.h"
#include "observe/cycle.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>

namespace test_cycle {

using namespace tumble;
using observe::Cycle;
using observe::find_cycle;
using tumble::test::about;

namespace {

struct Signal {
    std::vector<double> times, values;

    template <class Function> Signal(double until, double step, Function value) {
        for (int i = 0; i * step <= until; ++i) {
            times.push_back(i * step);
            values.push_back(value(i * step));
        }
    }
    [[nodiscard]] Cycle cycle() const { return find_cycle(times, values); }
};

double wave(double t) {
    return 0.06 + 0.035 * std::sin(2 * std::numbers::pi * t / 0.97 + 0.4);
}

} // namespace

TEST_CASE("a sine has its period, twice its amplitude and its number of cycles") {
    const Cycle cycle = Signal(4.7, 0.01, wave).cycle();
    CHECK(cycle.period == about(0.97, 0.011)); // a sample
    CHECK(cycle.peak_to_peak == about(0.07, 1e-3));
    // Turning points stand every 0.485 s from 0.18 s on. The first is not seen approached by 0.35 of the span, nor the
    // tenth, at 4.55 s, left by as much: eight, with seven half cycles between them.
    CHECK(cycle.cycles == 3.5);
    CHECK(cycle.highest == about(0.095, 1e-3));
    CHECK(cycle.lowest == about(0.025, 1e-2));
}

TEST_CASE("a cycle that was seen from top to top counts as one, from top to bottom as half of one") {
    // Of cos(2 pi t) the top at 0 is the record's end; tops and bottoms follow every 0.5 s.
    const auto cosine = [](double t) { return std::cos(2 * std::numbers::pi * t); };
    CHECK(Signal(0.9, 0.01, cosine).cycle().cycles == 0); // the bottom at 0.5 s alone
    CHECK(Signal(1.4, 0.01, cosine).cycle().cycles == 0.5);
    const Cycle whole = Signal(1.9, 0.01, cosine).cycle();
    CHECK(whole.cycles == 1);
    CHECK(whole.period == about(1.0, 0.011));
}

TEST_CASE("jitter of a tenth of the height makes no turning points of its own") {
    Rng rng(3);
    const Cycle cycle = Signal(9.7, 0.01, [&](double t) { return wave(t) + rng.uniform(-0.0035, 0.0035); }).cycle();
    CHECK(cycle.period == about(0.97, 0.05));
    CHECK(cycle.tops.size() >= 9); // of ten, the first rises from where the record begins
    CHECK(cycle.tops.size() <= 10);
    CHECK(cycle.peak_to_peak == about(0.077, 0.05)); // the extremes of the jitter add
}

TEST_CASE("cycles of uneven length and height give the median, not the mean") {
    // Cycles of 1.0, 0.9, 1.1, 1.0 s and, once, one that hangs for 2.5 s.
    const std::vector<double> lengths{1.0, 0.9, 1.1, 1.0, 2.5, 1.0, 1.0};
    const auto value = [&](double t) {
        for (const double length : lengths) {
            if (t < length)
                return 0.07 * std::pow(std::sin(std::numbers::pi * t / length), 2);
            t -= length;
        }
        return 0.0;
    };
    CHECK(Signal(8.5, 0.005, value).cycle().period == about(1.0, 0.06));
}

TEST_CASE("what never turns has no cycle, and values that are no numbers are left out") {
    const Cycle line = Signal(3, 0.01, [](double t) { return 2 * t; }).cycle();
    CHECK(std::isnan(line.period));
    CHECK(std::isnan(line.peak_to_peak));
    CHECK(line.cycles == 0);
    CHECK(std::isnan(Signal(3, 0.01, [](double) { return 1.0; }).cycle().period));
    CHECK(std::isnan(find_cycle({}, {}).lowest));
    const Cycle holes = Signal(4.7, 0.01, [](double t) {
                            return std::fmod(t, 0.05) < 0.01 ? std::numeric_limits<double>::quiet_NaN() : wave(t);
                        }).cycle();
    CHECK(holes.period == about(0.97, 0.02));
}

} // namespace test_cycle
