#include "about.h"
#include "excitation/knock.h"
#include "synthetic.h"

#include <array>
#include <tuple>

namespace test_knock {

using namespace tumble;
using namespace tumble::excitation;
using namespace tumble::excitation::testing;
using tumble::test::about;

namespace {

/// Modes of 80 and 120 Hz (the trough of the thesis, section 5.2.1), 2 % and 1 % of critical damping, struck twice.
Record struck(double noise, std::uint64_t seed, double second_mode = 0.7) {
    Rng rng(seed);
    Record record;
    record.file = "struck.csv";
    Channel y{"ay", 1, 0, {}};
    for (int k = 0; k < 6000; ++k) {
        const double t = k / 2000.0;
        record.time.push_back(t);
        double a = noise * normal(rng);
        for (const double knock : {0.5, 1.7}) {
            if (t < knock)
                continue;
            const double s = t - knock;
            for (const auto& [natural, damping, size] :
                 {std::array{80.0, 0.02, 1.0}, std::array{120.0, 0.01, second_mode}})
                a += size * (knock > 1 ? 0.6 : 1.0) * std::exp(-damping * 2 * pi * natural * s) *
                     std::cos(2 * pi * natural * std::sqrt(1 - damping * damping) * s);
        }
        y.values.push_back(a);
    }
    record.channels.push_back(std::move(y));
    return record;
}

} // namespace

TEST_CASE("knocks give the frequencies and dampings of what was struck") {
    const auto ringing = find_modes(struck(0.01, 1), {});
    REQUIRE_MESSAGE(ringing.ok(), to_string(ringing.problems()));
    REQUIRE(ringing->knocks.size() == 2);
    CHECK(ringing->knocks[0] == about(0.5, 0.01));
    REQUIRE(ringing->modes.size() == 2);
    for (const auto& [mode, natural, damping] :
         {std::tuple{ringing->modes[0], 80.0, 0.02}, {ringing->modes[1], 120.0, 0.01}}) {
        CHECK(std::abs(mode.frequency - natural) < 4.5 * mode.frequency_se);
        CHECK(std::abs(mode.damping - damping) < 4.5 * mode.damping_se);
        CHECK(mode.damping_se < 0.05 * damping);
    }
}

TEST_CASE("intervals of frequency and damping hold the truth in 95 % of the records") {
    int frequency = 0, damping = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const auto ringing = find_modes(struck(0.02, seed), {});
        REQUIRE(ringing.ok());
        REQUIRE(ringing->modes.size() == 2);
        frequency += std::abs(ringing->modes[0].frequency - 80) < 1.96 * ringing->modes[0].frequency_se;
        damping += std::abs(ringing->modes[0].damping - 0.02) < 1.96 * ringing->modes[0].damping_se;
    }
    // Binomial: 95 of 100, standard deviation 2.2; four of those.
    CHECK(frequency >= 86);
    CHECK(damping >= 86);
}

TEST_CASE("a record without a knock, or one that only makes a thud, is refused with a reason") {
    const auto quiet = find_modes(recorded({}, {.noise = 1}), {});
    REQUIRE_FALSE(quiet.ok());
    CHECK(quiet.problems()[0].what.starts_with("no knock stands out"));
    Record thud = recorded({}, {.noise = 0.01});
    for (int k = 0; k < 8; ++k)
        thud.channels[1].values[static_cast<std::size_t>(900 + k)] = 5 * std::sin(pi * k / 8);
    const auto none = find_modes(thud, {});
    REQUIRE_FALSE(none.ok());
    CHECK(none.problems()[0].what == "nothing rings after the knocks");
}

} // namespace test_knock
