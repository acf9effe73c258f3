#include "about.h"
#include "diagnose/data_doubts.h"
#include "diagnose/verdict.h"
#include "diagnose/warning_key.h"
#include "drops.h"

#include <doctest/doctest.h>

namespace test_slips {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::closed_form;
using tumble::test::Drops;
using tumble::test::floor_and_ball;

namespace {

Measurement with_times(double later, std::size_t first, std::size_t last) {
    Measurement measurement = Drops{}.measurement();
    for (std::size_t r = first; r <= last; ++r)
        for (double& time : measurement.records[r].time)
            time += later;
    return measurement;
}

} // namespace

TEST_CASE("a record whose time does not begin with the scene is told by the shift that makes it agree") {
    const Diagnosis late = Drops::diagnosed(with_times(0.5, 0, 3));
    CHECK(!names(late.decision));
    CHECK_MESSAGE(next_step(late).starts_with("First see to the time: '1.5' agrees with the simulation "),
                  next_step(late));
    const std::string told = next_step(late);
    CHECK(std::stod(told.substr(told.find("begins ") + 7)) == about(0.5, 0.01));
    CHECK(told.find(" s earlier") != std::string::npos);
    const Diagnosis early = Drops::diagnosed(with_times(-0.3, 2, 2));
    const Problem* warning = warned_of(early.warnings, warning_key::shifted);
    REQUIRE(warning);
    CHECK_MESSAGE(warning->what.starts_with("'1.1' agrees"), warning->what);
    CHECK(warning->what.find("s later") != std::string::npos);
    CHECK(!warned_of(Drops{.offset = 0.01}.diagnosis().warnings, warning_key::shifted)); // a clock's
    CHECK(!warned_of(Drops{.restitution = 0.6}.diagnosis().warnings, warning_key::shifted));
}

TEST_CASE("a shift in time that a nuisance explains is no slip; one that stays is told before the search begins") {
    Measurement late = with_times(0.13, 0, 3); // a tenth of the records and more
    late.nuisances[1].spread = 0.1;
    const Diagnosis innocent = Drops::diagnosed(late);
    CHECK_MESSAGE(innocent.decision.outcome == Outcome::consistent, verdict_of(innocent));
    CHECK(!warned_of(innocent.warnings, warning_key::shifted));
    std::vector<std::string> stages;
    const auto told = diagnose::diagnose({floor_and_ball, "ball.toml"}, with_times(0.5, 0, 3), closed_form, false,
                                         [&](const std::string& stage) { stages.push_back(stage); });
    REQUIRE(told);
    REQUIRE(stages.size() > 1);
    CHECK_MESSAGE(stages[1].starts_with("goes on, though '1.5' agrees"), stages[1]);
}

TEST_CASE("time since 1970 is refused as time that does not count from the scene's beginning") {
    const auto refused = diagnose::diagnose({floor_and_ball, "ball.toml"}, with_times(1.7e9, 0, 3), closed_form);
    REQUIRE(!refused);
    CHECK_MESSAGE(refused.problems()[0].what.starts_with("'0.5' begins at 1700000000 s, and the scene ends at "),
                  refused.problems()[0].what);
}

TEST_CASE("a sensor that never changes is told as such, and not as one of coarse steps") {
    Measurement measurement = Drops{}.measurement();
    for (double& value : measurement.records[1].channels[0].value)
        value = 0.4;
    Problems warnings;
    doubt_record(measurement.records[1], warnings);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].key == warning_key::dead);
    const Diagnosis diagnosis = Drops::diagnosed([&] {
        measurement.warnings = warnings;
        return measurement;
    }());
    CHECK(!names(diagnosis.decision));
    CHECK_MESSAGE(next_step(diagnosis).starts_with("First see to the readings: height_m: all 150 readings are equal"),
                  next_step(diagnosis));
}

TEST_CASE("heights of a ball's lowest point that a zero explains are not blamed on the instrument") {
    Measurement lowest = Drops{.restitution = 0.8}.measurement(); // of the ball of 10 mm
    for (Record& record : lowest.records)
        for (double& value : record.channels[0].value)
            value -= 0.0102;
    lowest.causes.push_back("ins.bias");
    const Diagnosis diagnosis = Drops::diagnosed(lowest);
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK(diagnosis.causes[static_cast<std::size_t>(diagnosis.decision.causes[0])].id == "ins.bias");
    CHECK(outcome_words(diagnosis) == "UNSURE");
    CHECK_MESSAGE(
        next_step(diagnosis).starts_with("With a radius, 10 mm, added to the heights read only noise is left"),
        next_step(diagnosis));
}

} // namespace test_slips
