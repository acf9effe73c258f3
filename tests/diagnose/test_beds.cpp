#include "about.h"
#include "beds_of_a_formula.h"
#include "folder.h"

#include <doctest/doctest.h>

namespace test_beds {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::BedLaboratory;
using tumble::test::formula;
using tumble::test::shaken_box;

namespace {

Diagnosis diagnosed(const Measurement& measurement, const BedOptions& options = {.table = {}}) {
    auto result = diagnose_beds({shaken_box, "box.toml"}, measurement, formula, options);
    REQUIRE_MESSAGE(result, to_string(result.problems()));
    return std::move(*result);
}

std::string named(const Diagnosis& diagnosis) {
    return diagnosis.decision.causes.empty()
               ? ""
               : diagnosis.causes[static_cast<std::size_t>(diagnosis.decision.causes[0])].id;
}

} // namespace

TEST_CASE("a bed that is as its scene has it agrees with it, and alarms are as rare as promised") {
    // Gate and adequacy alarm in 0.5 % each, the latter twice: 0.6 of 40 cases; 4 or more have a probability of 0.3 %.
    int alarms = 0;
    for (std::uint64_t k = 0; k < 40; ++k) {
        const Diagnosis diagnosis = diagnosed(BedLaboratory{.hidden = {}, .seed = 1000 + 50 * k}.measurement());
        alarms += diagnosis.decision.outcome == Outcome::consistent ? 0 : 1;
    }
    CHECK(alarms < 4);
}

TEST_CASE("a phase that was dropped is named, with its angle on the right side of a wave, and put into the scene") {
    // -0.2 sin(120 deg) = -0.17 rad/s of 0.02 / sqrt(4) (1 + 1): 12 standard errors, far from what a tilt does.
    const Diagnosis diagnosis = diagnosed(BedLaboratory{.hidden = {"wall.0.motion.1.phase_deg=120"}}.measurement());
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK_MESSAGE(diagnosis.decision.sure, verdict_of(diagnosis));
    CHECK(named(diagnosis) == "exc.phase");
    const Refit& best = *diagnosis.decision.best;
    // sin alone cannot tell 120 from 60 degrees.
    CHECK(std::abs(std::sin(best.amplitude[0] / 57.29577951308232) - std::sin(120 / 57.29577951308232)) < 0.2);
    REQUIRE(diagnosis.confirmation);
    CHECK(diagnosis.confirmation->p > 0.005);
    REQUIRE(diagnosis.extended);
    CHECK(diagnosis.extended->walls[0].motion.harmonics[1].phase * 57.29577951308232 ==
          about(best.amplitude[0], 0.005));
    CHECK(diagnosis.extended->walls[0].motion.harmonics[0].phase == 0);
    REQUIRE(diagnosis.gain);
    CHECK(diagnosis.gain->shown);
    CHECK(diagnosis.beds.size() == 4);
    for (const BedNumber& one : diagnosis.beds) {
        CHECK(one.has_extended);
        CHECK(std::abs(one.measured - one.extended) < 5 * std::hypot(one.measured_error, one.extended_error));
    }
}

TEST_CASE("a tilt and a load that differs are told from each other, each with its amplitude") {
    const Diagnosis tilt = diagnosed(BedLaboratory{.hidden = {"gravity_m_s2=[0.3425, -9.804]"}}.measurement());
    REQUIRE_MESSAGE(tilt.decision.outcome == Outcome::named, verdict_of(tilt));
    CHECK(named(tilt) == "grav.tilt_x");
    // 2 deg of slope per deg, to 1 / sqrt(4) sqrt(2) for either of two conditions: 0.25 deg.
    CHECK(std::abs(tilt.decision.best->amplitude[0] - 2) < 4 * 0.25);
    CHECK(tilt.decision.best->error[0] == about(0.25, 0.4));
    // A load does not show where nothing circulates.
    for (std::size_t k = 0; k < tilt.causes.size(); ++k)
        if (tilt.causes[k].id == "load.fill" || tilt.causes[k].id == "rest.factor")
            CHECK_MESSAGE(!tilt.decision.seen[k].visible, tilt.causes[k].id);
}

TEST_CASE("something that no cause does is none of the known ones") {
    Measurement measurement = BedLaboratory{.hidden = {}}.measurement();
    measurement.bulks[0].numbers[1].value += 12; // degrees of slope, to either side
    measurement.bulks[1].numbers[1].value -= 12;
    const Diagnosis diagnosis = diagnosed(measurement);
    CHECK_MESSAGE(diagnosis.decision.outcome == Outcome::none_known, verdict_of(diagnosis));
}

TEST_CASE("a condition held out is never fitted, and the gain is measured on it") {
    Measurement measurement = BedLaboratory{.hidden = {"wall.0.motion.1.phase_deg=90"}}.measurement();
    measurement.bulks[1].held_out = true;
    const Diagnosis diagnosis = diagnosed(measurement);
    CHECK(diagnosis.readings == 2);
    CHECK_MESSAGE(named(diagnosis) == "exc.phase", verdict_of(diagnosis));
    REQUIRE(diagnosis.gain);
    CHECK(diagnosis.gain->held_out);
    CHECK(diagnosis.gain->scores.size() == 1);
    CHECK(diagnosis.gain->shown);
}

TEST_CASE("a camera that may lean hides a tilt: said to be innocent, the zero of its slopes takes it over") {
    Measurement measurement = BedLaboratory{.hidden = {}}.measurement();
    for (Bulk& bulk : measurement.bulks)
        bulk.numbers[1].value += 4; // deg of slope, as a tilt of 2 deg has it
    const Diagnosis suspected = diagnosed(measurement);
    CHECK_MESSAGE(named(suspected) == "grav.tilt_x", verdict_of(suspected));
    measurement.nuisances = {{.key = "", .instrument = "", .measure = "surface_slope"}};
    const Diagnosis innocent = diagnosed(measurement);
    CHECK_MESSAGE(innocent.decision.outcome == Outcome::consistent, verdict_of(innocent));
    for (std::size_t k = 0; k < innocent.causes.size(); ++k)
        if (innocent.causes[k].id == "grav.tilt_x")
            CHECK(!innocent.decision.seen[k].visible);
    REQUIRE(innocent.nuisances.size() == 1);
    // Of two conditions, each of 1 deg / sqrt(4) in four runs and as much in four seeds: 0.5 deg.
    CHECK(std::abs(innocent.nuisances[0].value - 4) < 4 * 0.5);
    CHECK(innocent.nuisances[0].error == about(0.5, 0.4));
    for (const BedNumber& one : innocent.beds) // shown as adjusted
        CHECK(std::abs(one.measured - one.baseline) < 4 * std::hypot(one.measured_error, one.baseline_error));
}

TEST_CASE(
    "a cause that is said to be innocent is adjusted within what is known of it, and the guilty one still named") {
    const std::vector<Nuisance> tilted{
        {.key = "", .instrument = "", .spread = 1, .measure = "", .cause = "grav.tilt_x"}};
    Measurement measurement = BedLaboratory{.hidden = {"gravity_m_s2=[0.3425, -9.804]"}}.measurement(); // 2 deg
    measurement.nuisances = tilted;
    const Diagnosis alone = diagnosed(measurement);
    CHECK_MESSAGE(alone.decision.outcome == Outcome::consistent, verdict_of(alone));
    CHECK(alone.causes.size() == 4); // it is no suspect
    // Slopes tell 0.25 deg; with a prior of 1 deg: 2 / (1 + 0.25^2).
    CHECK(std::abs(alone.nuisances.at(0).value - 1.88) < 4 * 0.25);
    measurement =
        BedLaboratory{.hidden = {"gravity_m_s2=[0.3425, -9.804]", "wall.0.motion.1.phase_deg=120"}}.measurement();
    measurement.nuisances = tilted;
    const Diagnosis both = diagnosed(measurement);
    CHECK_MESSAGE(both.decision.outcome == Outcome::named, verdict_of(both));
    CHECK(named(both) == "exc.phase");
    REQUIRE(both.extended);
    CHECK(both.extended->gravity.x() > 0.15); // what is innocent goes into the scene, too
}

TEST_CASE("a plan holds the name against its nearest rival, and runs the conditions that could be measured besides") {
    const Measurement measurement = BedLaboratory{.hidden = {"wall.0.motion.1.phase_deg=90"}, .runs = 2}.measurement();
    const auto proposals = [&](bool plan) { return diagnosed(measurement, {.table = {}, .plan = plan}).proposals; };
    CHECK(proposals(false).empty());
    const std::vector<Proposal> planned = proposals(true);
    const auto of = [&](const std::string& id) {
        const auto found = std::find_if(planned.begin(), planned.end(), [&](const auto& one) { return one.id == id; });
        return found == planned.end() ? 0.0 : found->separation;
    };
    REQUIRE(of("more-runs") > 0);
    // A tilt does to slopes what the phase does; circulation, 0.2 and 0.3 rad/s of the two loads, tells them apart. The
    // first load once more, leaning: sqrt(1 + 0.04 / (0.04 + 0.09)) = 1.14 times as far, with a scatter of its own.
    CHECK(of("leaning") > 1.05 * of("more-runs"));
    CHECK(of("leaning") < 1.4 * of("more-runs"));
    for (const Proposal& one : planned) {
        CAPTURE(one.id);
        CHECK(std::isfinite(one.separation));
        CHECK(one.repeats == std::max(1.0, std::ceil(25 / (one.separation * one.separation))));
    }
}

TEST_CASE("the response table keeps every run: more seeds and causes add to it, another program does not trust it") {
    const test::Folder folder;
    const Measurement measurement = BedLaboratory{.hidden = {}}.measurement();
    int calls = 0;
    const Simulate counted = [&](const scene::Scene& scene) {
        ++calls;
        return formula(scene);
    };
    const auto runs_of = [&](std::vector<std::string> causes, int seeds, const std::string& version) {
        Measurement some = measurement;
        some.causes = std::move(causes);
        const BedOptions options{.table = folder.path / "t.csv", .seeds = seeds, .version = version};
        const auto budget = budget_of_beds({shaken_box, "box.toml"}, some, options);
        REQUIRE(budget);
        calls = 0;
        REQUIRE(diagnose_beds({shaken_box, "box.toml"}, some, counted, options));
        CHECK(budget->runs == calls);
        return calls;
    };
    CHECK(runs_of({"load.fill"}, 3, "1") == 2 * 3 * (1 + 2));
    CHECK(runs_of({"load.fill"}, 3, "1") == 0);
    CHECK(runs_of({"load.fill"}, 4, "1") == 2 * (1 + 2));
    CHECK(runs_of({"load.fill", "rest.factor", "grav.tilt_z"}, 4, "1") == 2 * 4 * 2); // tilt_z is nothing in a plane
    CHECK(runs_of({"load.fill"}, 4, "2") == 2 * 4 * (1 + 2));
}

TEST_CASE("a run that breaks down under a cause halves its amplitude; a bed that breaks down by itself is refused") {
    const Simulate fragile = [](const scene::Scene& scene) -> Result<observe::Series> {
        if (std::abs(scene.gravity.x()) > 0.3) // tilted by more than 1.75 degrees
            return Problem{.what = "a body left the domain"};
        return formula(scene);
    };
    Measurement measurement = BedLaboratory{.hidden = {"gravity_m_s2=[0.1, -9.81]"}}.measurement();
    auto result = diagnose_beds({shaken_box, "box.toml"}, measurement, fragile, {.table = {}});
    REQUIRE(result);
    for (const Cause& cause : result->causes)
        if (cause.id == "grav.tilt_x")
            CHECK(cause.hi == about(1.25)); // half of 2.5
    const auto refused =
        diagnose_beds({shaken_box, "box.toml", {{"gravity_m_s2=[1, -9.81]"}}}, measurement, fragile, {.table = {}});
    REQUIRE(!refused);
    CHECK(refused.problems()[0].what == "a body left the domain");
}

} // namespace test_beds
