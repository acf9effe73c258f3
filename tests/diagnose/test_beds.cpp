#include "about.h"
#include "beds_of_a_formula.h"
#include "folder.h"

#include <doctest/doctest.h>
#include <fstream>

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

TEST_CASE("what is innocent acts on conditions held out, too, and on the runs that confirm a name") {
    // A tilt of 2 deg adds 4 deg to every slope. Means of 16 runs less those of 16 seeds scatter by 0.35 deg, so that
    // the tilt is known to 0.18 deg from one condition, and foretells the slope of the other to 0.35 deg.
    Measurement measurement =
        BedLaboratory{.hidden = {"gravity_m_s2=[0.3425, -9.804]", "wall.0.motion.1.phase_deg=90"}, .runs = 16}
            .measurement();
    measurement.nuisances = {{.key = "", .instrument = "", .spread = 4, .measure = "", .cause = "grav.tilt_x"}};
    measurement.bulks[1].held_out = true;
    int calls = 0;
    const Simulate counted = [&](const scene::Scene& scene) {
        ++calls;
        if (scene.seed >= 1000) // those that confirm
            CHECK(scene.gravity.x() > 0);
        return formula(scene);
    };
    const BedOptions options{.table = {}, .seeds = 16};
    const auto budget = budget_of_beds({shaken_box, "box.toml"}, measurement, options);
    REQUIRE(budget);
    auto result = diagnose_beds({shaken_box, "box.toml"}, measurement, counted, options);
    REQUIRE(result);
    CHECK_MESSAGE(named(*result) == "exc.phase", verdict_of(*result));
    CHECK(calls == budget->runs + 2 * 16); // and those that confirm, under either condition
    REQUIRE(result->confirmation);
    CHECK(result->confirmation->p > 0.005);
    for (const BedNumber& one : result->beds)
        if (one.held_out)
            CHECK(std::abs(one.measured - one.extended) <
                  4 * std::hypot(one.measured_error, one.extended_error, one.measure == "surface_slope" ? 0.35 : 0));
}

TEST_CASE("an innocent cause that would have to go beyond what is plausible stops there, and is warned of") {
    // 12 deg of slope at 2 deg per degree: a tilt of 6 deg, where 2.5 were run and nothing is known beforehand.
    Measurement measurement = BedLaboratory{.hidden = {"wall.0.motion.1.phase_deg=90"}}.measurement();
    for (Bulk& bulk : measurement.bulks)
        bulk.numbers[1].value += 12;
    measurement.nuisances = {{.key = "", .instrument = "", .measure = "", .cause = "grav.tilt_x"}};
    const Diagnosis diagnosis = diagnosed(measurement);
    REQUIRE_MESSAGE(named(diagnosis) == "exc.phase", verdict_of(diagnosis));
    REQUIRE(diagnosis.extended);
    CHECK(57.29577951308232 * std::atan2(diagnosis.extended->gravity.x(), -diagnosis.extended->gravity.y()) ==
          about(2.5));
    const auto warned = std::find_if(diagnosis.warnings.begin(), diagnosis.warnings.end(),
                                     [](const Problem& one) { return one.key == "innocent cause out of range"; });
    REQUIRE(warned != diagnosis.warnings.end());
    CHECK(warned->what.starts_with("grav.tilt_x would fit best at "));
    CHECK(warned->what.ends_with("beyond the -2.5 to 2.5 that were run"));
}

TEST_CASE("a condition that is only planned has a zero of its own where each condition has one") {
    // Phase and tilt do alike to slopes, and circulation says nothing, for its zero is unknown under each condition:
    // neither would it under a third one, where its 0.2 rad/s would stand 14 standard errors from none.
    Measurement measurement = BedLaboratory{.hidden = {"wall.0.motion.1.phase_deg=90"}}.measurement();
    measurement.nuisances = {{.key = "", .instrument = "", .per_record = true, .measure = "circulation"}};
    const std::vector<Proposal> planned = diagnosed(measurement, {.table = {}, .plan = true}).proposals;
    REQUIRE(!planned.empty());
    for (const Proposal& one : planned)
        CHECK_MESSAGE(one.separation < 5, one.id); // four seeds leave some difference between the two
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
    const double now = of("more-runs") / std::sqrt(2); // the same again, simulated again
    REQUIRE(now > 0);
    // A tilt does to slopes what the phase does; circulation, 0.2 and 0.3 rad/s of the two loads, tells them apart. The
    // first load once more, leaning: sqrt(1 + 0.04 / (0.04 + 0.09)) = 1.14 times as far, with a scatter of its own.
    CHECK(of("leaning") > 1.05 * now);
    CHECK(of("leaning") < 1.4 * now);
    for (const Proposal& one : planned) {
        CAPTURE(one.id);
        CHECK(std::isfinite(one.separation));
        CHECK(one.reached >= 5);
    }
}

TEST_CASE("what an experiment adds is repeated, not what there was before it") {
    const Proposal beside = proposal_of("", "", std::sqrt(10), 3), more_read = proposal_of("", "", 2.5);
    CHECK(beside.repeats == 16); // 9 + 16 * 1 = 25
    CHECK(beside.reached == about(5, 1e-12));
    CHECK(more_read.repeats == 4);
    CHECK(more_read.reached == about(5, 1e-12));
    CHECK(proposal_of("", "", 7, 3).repeats == 1);
    CHECK(proposal_of("", "", 7, 3).reached == about(7, 1e-12));
    CHECK(proposal_of("", "", 3.0001, 3).repeats == 0);
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

TEST_CASE("runs that go side by side fill the same table") {
    const test::Folder folder;
    const Measurement measurement = BedLaboratory{.hidden = {}}.measurement();
    const auto means_with = [&](int threads) {
        const BedOptions options{.table = folder.path / fmt::format("{}.csv", threads), .seeds = 4, .version = "1"};
        REQUIRE(diagnose_beds({shaken_box, "box.toml"}, measurement, Simulate(formula, threads), options));
        const auto table = ResponseTable::open(options.table, {});
        REQUIRE(table);
        std::vector<std::map<std::string, double>> means;
        for (const BedRun& run : table->runs())
            means.push_back(run.means);
        return means;
    };
    const auto alone = means_with(1);
    CHECK(alone.size() > 20);
    CHECK(means_with(3) == alone); // 4 seeds are a batch of 3 and one of 1
}

TEST_CASE("old runs count where they are trusted, each told of, and never those of another scene") {
    const test::Folder folder;
    Measurement measurement = BedLaboratory{.hidden = {}}.measurement();
    measurement.causes = {"load.fill"};
    int calls = 0;
    const Simulate counted = [&](const scene::Scene& scene) {
        ++calls;
        return formula(scene);
    };
    const auto table = folder.path / "t.csv";
    const auto diagnosis_of = [&](const std::string& toml, const std::string& version, bool any_date) {
        calls = 0;
        auto result = diagnose_beds({toml, "box.toml"}, measurement, counted,
                                    {.table = table, .seeds = 3, .version = version, .any_date = any_date});
        REQUIRE_MESSAGE(result, to_string(result.problems()));
        return std::move(*result);
    };
    const auto warned = [](const Diagnosis& diagnosis, const std::string& key) -> std::string {
        for (const Problem& one : diagnosis.warnings)
            if (one.key == key)
                return one.what;
        return "";
    };
    const int all = 2 * 3 * (1 + 2); // conditions, seeds, the bed as it is and with either load
    CHECK(warned(diagnosis_of(shaken_box, "1", true), "old runs").empty());
    CHECK(calls == all);
    const Diagnosis trusted = diagnosis_of(shaken_box, "2", true);
    CHECK(calls == 0);
    CHECK(trusted.old_runs == all);
    CHECK(warned(trusted, "old runs").starts_with("18 of the runs that count were made by another version"));
    CHECK(warned(trusted, "runs left aside").empty());

    std::string other = shaken_box;
    other.replace(other.find("amplitude_m = 0.001"), 19, "amplitude_m = 0.002");
    const Diagnosis changed = diagnosis_of(other, "2", true);
    CHECK(calls == all);
    CHECK(changed.old_runs == 0);
    CHECK(warned(changed, "runs left aside").starts_with("18 of the runs kept"));

    // A table from before runs were dated by their scene: its heads and lines without that column.
    std::ifstream stream(table);
    const std::string lines{std::istreambuf_iterator<char>(stream), {}};
    std::string undated;
    for (std::size_t at = 0, end = 0; (end = lines.find('\n', at)) != std::string::npos; at = end + 1) {
        std::string line = lines.substr(at, end - at);
        std::size_t cell = 0;
        for (int k = 0; k < 8; ++k)
            cell = line.find(',', cell) + 1;
        if (line[0] != '#')
            line.erase(cell, line.find(',', cell) + 1 - cell);
        undated += line + "\n";
    }
    std::ofstream(table) << undated;
    CHECK(diagnosis_of(shaken_box, "1", false).old_runs == 0);
    CHECK(calls == 0); // the runs themselves are dated
    const Diagnosis unknown = diagnosis_of(shaken_box, "3", true);
    CHECK(calls == all);
    CHECK(unknown.old_runs == 0);
    CHECK(warned(unknown, "runs left aside").starts_with("18 of the runs kept"));
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
