// Numbers of a bed that are no means over time: of what a body carried through it, whose path never repeats.
#include "about.h"
#include "beds_of_a_formula.h"
#include "diagnose/bed_number.h"
#include "folder.h"

#include <doctest/doctest.h>
#include <numbers>

namespace test_bed_number {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;

namespace {

struct Wave {
    std::vector<double> time, value;
};

Wave wave(double amplitude, double period) {
    Wave all;
    for (int k = 0; k <= 4000; ++k) {
        all.time.push_back(1e-3 * k);
        all.value.push_back(0.3 + amplitude * std::sin(2 * std::numbers::pi * 1e-3 * k / period));
    }
    return all;
}

double over(const std::string& take, const Wave& all) {
    return number_over(take, all.time, all.value, 0, 4, 1e-3);
}

/// A body that a bed carries round: how fast up and down goes with the sine of the shaking's phase, and with the seed.
Result<observe::Series> carried(const scene::Scene& scene) {
    REQUIRE(scene.observe.measures.back() == "tracer:disc");
    const double phase = scene.walls[0].motion.harmonics[1].phase;
    Rng rng(scene.seed * 7919 + static_cast<std::uint64_t>(std::llround(1e6 * (phase + 100))));
    const double speed = (0.1 + 0.05 * std::sin(phase)) * (1 + 0.05 * test::gauss(rng));
    const double period = 0.2 * (1 + 0.05 * test::gauss(rng));
    observe::Series series;
    series.columns = {"time_s", "tracer:disc_vy_m_s"};
    series.values.resize(2);
    for (int k = 0; k <= 400; ++k)
        series.append({0.005 * k, speed * std::sin(2 * std::numbers::pi * 0.005 * k / period)});
    return series;
}

std::string sensed(double phase_deg) {
    std::string toml =
        "title = \"a sensor in a bed\"\ncauses = [\"exc.phase\", \"grav.tilt_x\"]\n[[bulk]]\nname = \"one\"\n"
        "runs = 4\nfrom_s = 1\nuntil_s = 2\n";
    for (const auto& [take, unit, value, sigma] :
         {std::tuple{"q90", "m_s", 0.951 * (0.1 + 0.05 * std::sin(phase_deg / 57.29577951308232)), 0.005},
          {"cycle", "s", 0.2, 0.01}})
        toml += fmt::format("[[bulk.number]]\nmeasure = \"tracer:disc_vy\"\ntake = \"{}\"\nvalue = {}\nunit = \"{}\"\n"
                            "sigma = {}\n",
                            take, value, unit, sigma);
    return toml;
}

Diagnosis diagnosed(double phase_deg) {
    const test::Folder folder;
    test::put(folder.path / "m.toml", sensed(phase_deg));
    const auto read = load_measurement(folder.path / "m.toml");
    REQUIRE_MESSAGE(read, to_string(read.problems()));
    CHECK(read->bulks[0].numbers[0].measure == "q90 of tracer:disc_vy");
    CHECK(read->bulks[0].numbers[1].unit == "s");
    auto result = diagnose_beds({test::shaken_box, "box.toml"}, *read, carried, {.table = {}, .seeds = 6});
    REQUIRE_MESSAGE(result, to_string(result.problems()));
    return std::move(*result);
}

} // namespace

TEST_CASE("quantiles, root mean squares and cycles of a wave are its own") {
    const Wave all = wave(0.2, 0.5);
    CHECK(over("mean", all) == about(0.3, 1e-3));
    CHECK(over("rms", all) == about(std::sqrt(0.09 + 0.02), 1e-3));
    CHECK(over("q50", all) == about(0.3, 1e-2));
    CHECK(over("q90", all) == about(0.3 + 0.2 * std::sin(0.4 * std::numbers::pi), 1e-3));
    CHECK(over("q10", all) == about(0.3 - 0.2 * std::sin(0.4 * std::numbers::pi), 1e-2));
    CHECK(over("cycle", all) == about(0.5, 1e-3));
    CHECK(std::isnan(over("cycle", wave(0.2, 3))));
}

TEST_CASE("rows without a value are left out, and most of them leave no number") {
    Wave all = wave(0.2, 0.5);
    for (std::size_t k = 0; k < all.value.size(); k += 3)
        all.value[k] = std::nan("");
    CHECK(over("q90", all) == about(0.3 + 0.2 * std::sin(0.4 * std::numbers::pi), 1e-2));
    for (std::size_t k = 0; k < all.value.size(); ++k)
        if (k % 3)
            all.value[k] = std::nan("");
    CHECK(std::isnan(over("q90", all)));
}

TEST_CASE("names of numbers are joined and parted") {
    CHECK(bed_number_named("circulation").take == "mean");
    CHECK(bed_number_named("q90 of tracer:a_vy").measure == "tracer:a_vy");
    CHECK(BedNumberName{"q90", "tracer:a_vy"}.joined() == "q90 of tracer:a_vy");
    CHECK(observed_for({"q90", "tracer:a_vy"}) == "tracer:a");
    CHECK(*head_of({"cycle", "tracer:a_y"}) == "cycle of tracer:a_y_m");
}

TEST_CASE("what carries a sensor through a bed is told by how fast the sensor goes") {
    const Diagnosis quiet = diagnosed(0), hidden = diagnosed(70);
    CHECK_MESSAGE(quiet.decision.outcome == Outcome::consistent, verdict_of(quiet));
    REQUIRE_MESSAGE(!hidden.decision.causes.empty(), verdict_of(hidden));
    CHECK(hidden.causes[static_cast<std::size_t>(hidden.decision.causes[0])].id == "exc.phase");
    CHECK(hidden.decision.largest > hidden.decision.gate);
}

} // namespace test_bed_number
