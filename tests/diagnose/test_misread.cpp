// Records that agree with the simulation once they are read otherwise than their files say.
#include "about.h"
#include "diagnose/considered.h"
#include "diagnose/fit_doubts.h"
#include "diagnose/misread.h"
#include "diagnose/refit.h"
#include "diagnose/verdict.h"
#include "drops.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace test_misread {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::bouncing;
using tumble::test::closed_form;
using tumble::test::Drops;
using tumble::test::floor_and_ball;

namespace {

/// What a diagnosis of four drops says of itself once `slip` has been at their records.
template <class Slip> Diagnosis with(Slip slip, double restitution = 0.79) {
    Measurement measurement = Drops{.restitution = restitution}.measurement();
    slip(measurement.records);
    return Drops::diagnosed(measurement);
}

double number_after(const std::string& text, const std::string& words) {
    REQUIRE_MESSAGE(text.find(words) != std::string::npos, text);
    return std::stod(text.substr(text.find(words) + words.size()));
}

std::vector<std::string> warned(const Diagnosis& diagnosis, const std::string& key) {
    std::vector<std::string> what;
    for (const Problem& warning : diagnosis.warnings)
        if (warning.key == key)
            what.push_back(warning.what);
    return what;
}

} // namespace

TEST_CASE("two records that were exchanged are told, each with the condition that it is of") {
    const Diagnosis swapped =
        with([](std::vector<Record>& records) { std::swap(records[1].channels, records[2].channels); });
    CHECK(!names(swapped.decision));
    const auto told = warned(swapped, warning_key::condition);
    REQUIRE(told.size() == 2);
    CHECK_MESSAGE(told[0].starts_with("'1.1' agrees with the simulation "), told[0]); // what mends most comes first
    CHECK_MESSAGE(told[0].ends_with(" times as well if it is of the condition of '0.8'"), told[0]);
    CHECK_MESSAGE(told[1].ends_with("if it is of the condition of '1.1'"), told[1]);
    CHECK_MESSAGE(next_step(swapped).starts_with("First see to the files: '1.1' agrees"), next_step(swapped));
}

TEST_CASE("a wrong rate of frames is told once for all records, and a clock that runs 2 % fast is none") {
    const auto at_rate = [](double rate) {
        return with([rate](std::vector<Record>& records) {
            for (Record& record : records)
                for (double& time : record.time)
                    time *= rate;
        });
    };
    const Diagnosis slow = at_rate(1.2);
    const auto told = warned(slow, warning_key::rate);
    REQUIRE(told.size() == 1);
    CHECK_MESSAGE(told[0].starts_with("4 records agree with the simulation "), told[0]);
    CHECK(std::abs(number_after(told[0], "time runs ") * 1.2 - 1) < 0.01);
    CHECK_MESSAGE(next_step(slow).starts_with("First see to the time: 4 records"), next_step(slow));
    const Diagnosis clock = at_rate(1.02);
    CHECK(warned(clock, warning_key::rate).empty());
    CHECK(warned(clock, warning_key::shifted).empty());
}

TEST_CASE("heights that are read downwards, from the ceiling too, are told by their sign") {
    const auto from = [](double ceiling) {
        return with([ceiling](std::vector<Record>& records) {
            for (double& value : records[3].channels[0].value)
                value = ceiling - value;
        });
    };
    const auto down = warned(from(0), warning_key::turned);
    REQUIRE(down.size() == 1);
    CHECK_MESSAGE(down[0].ends_with("if the sign of height_m is turned"), down[0]);
    const auto ceiling = warned(from(2.5), warning_key::turned);
    REQUIRE(ceiling.size() == 1);
    CHECK(std::abs(number_after(ceiling[0], "the sign of height_m is turned and ") - 2.5) < 0.02);
}

TEST_CASE("a zero of one record is a slip, one of all is the instrument's") {
    const auto moved = [](std::size_t first) {
        return with([first](std::vector<Record>& records) {
            for (std::size_t r = first; r < records.size(); ++r)
                for (double& value : records[r].channels[0].value)
                    value += 0.3;
        });
    };
    const auto told = warned(moved(3), warning_key::zero);
    REQUIRE(told.size() == 1);
    CHECK(std::abs(number_after(told[0], " times as well if ") - 0.3) < 0.02);
    CHECK(warned(moved(0), warning_key::zero).empty());
}

TEST_CASE("frames that were lost are told by where the time jumps, a scale by its factor, a start by both places") {
    const Diagnosis lost = with(
        [](std::vector<Record>& records) {
            const auto lose = [](std::vector<double>& column) {
                column.erase(column.begin() + 72, column.begin() + 84);
            };
            lose(records[2].time);
            lose(records[2].channels[0].value);
            for (double& time : records[2].time)
                time -= time > 0.6 ? 0.1 : 0; // numbered on
        },
        0.8);
    const auto jumps = warned(lost, warning_key::jump);
    REQUIRE_MESSAGE(jumps.size() == 1, (to_string(lost.warnings) + verdict_of(lost)));
    CHECK_MESSAGE(jumps[0].starts_with("'1.1' agrees with the simulation "), jumps[0]);
    CHECK(std::abs(number_after(jumps[0], "if its time is ") - 0.1) < 0.01);
    CHECK(std::abs(number_after(jumps[0], " s more from ") - 0.6) < 0.05);
    CHECK_MESSAGE(next_step(lost).starts_with("First see to the time: '1.1' agrees"), next_step(lost));

    const Diagnosis pixels = with([](std::vector<Record>& records) {
        for (Record& record : records)
            for (double& value : record.channels[0].value)
                value *= 0.63;
    });
    const auto scales = warned(pixels, warning_key::scale);
    REQUIRE(scales.size() == 4);
    CHECK(std::abs(number_after(scales[0], "if height_m is ") * 0.63 - 1) < 0.03);

    const Diagnosis higher = with([](std::vector<Record>& records) { records[3].sets = records[2].sets; });
    const auto starts = warned(higher, warning_key::starts);
    REQUIRE(starts.size() == 1);
    CHECK(std::abs(number_after(starts[0], "height_m of '1.5' begins at ") - 1.5) < 0.01);
    CHECK_MESSAGE(starts[0].ends_with(", and the scene there at 1.1 m"), starts[0]);
}

TEST_CASE("a slip is told of the record that has it, though another is late as far as its clock may be") {
    Measurement measurement = Drops{}.measurement();
    measurement.nuisances[1].spread = 0.1;
    for (double& time : measurement.records[1].time)
        time += 0.12;
    for (double& value : measurement.records[0].channels[0].value)
        value = -value;
    const Diagnosis both = Drops::diagnosed(measurement);
    CHECK_MESSAGE(next_step(both).starts_with("First see to the files: '0.5' agrees"), next_step(both));
    for (double& value : measurement.records[3].channels[0].value) // refused, whatever else is wrong
        value *= 1000;
    const auto refused = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement, closed_form);
    REQUIRE(!refused);
    CHECK(refused.problems()[0].what.starts_with("height_m spans 1"));
}

TEST_CASE("series of one set that differ by far are told, unless their sensors or throws do") {
    std::vector<Record> records(2);
    for (std::size_t r = 0; r < 2; ++r) {
        Channel heights{.head = "height_m", .measure = "centre_of_mass_y", .unit = "m", .value = {}, .sigma = 1e-3};
        for (int k = 0; k < 50; ++k) {
            records[r].time.push_back(0.01 * k);
            heights.value.push_back(bouncing(r == 0 ? 0.5 : 0.8, 9.81, 0.8, 0.01 * k) + 1e-3 * (k % 2));
        }
        records[r].name = std::to_string(r);
        records[r].channels = {heights};
    }
    const auto told = forgotten_sets(records);
    REQUIRE(told.size() == 1);
    CHECK(told[0].records == std::vector<std::size_t>{1});
    records[1].channels[0].sensor = "right";
    CHECK(forgotten_sets(records).empty());
    records[1].channels[0].sensor = "";
    records[1].channels[0].value = records[0].channels[0].value;
    for (std::size_t k = 0; k < 50; ++k)
        records[1].channels[0].value[k] += 1e-3 * static_cast<double>(k % 3);
    CHECK(forgotten_sets(records).empty());
}

TEST_CASE("a sensor that held on to a reading is told where the simulation moves, and rest is none") {
    Record record;
    Channel heights{.head = "height_m", .measure = "centre_of_mass_y", .unit = "m", .value = {}, .sigma = 1e-3};
    Signal falling, resting;
    for (int k = 0; k < 60; ++k) {
        const double t = 0.01 * k, y = bouncing(1, 9.81, 0.8, t);
        record.time.push_back(t);
        falling.time.push_back(t);
        falling.value.push_back(y);
        resting.time.push_back(t);
        resting.value.push_back(k < 40 ? 0.5 : y);
        heights.value.push_back(k >= 20 && k < 30 ? bouncing(1, 9.81, 0.8, 0.2) : y);
    }
    record.channels = {heights};
    const auto held = held_readings(record, {{falling}, {1e-3}});
    REQUIRE(held);
    CHECK_MESSAGE(held->what.starts_with("height_m: 10 equal readings in a row (0.2 to 0.29 s), and then a leap"),
                  held->what);
    CHECK(!held_readings(record, {{resting}, {1e-3}}));
}

TEST_CASE("what effects do is no slip: restitution, drag, gain and clipping leave no such warning") {
    for (double (*distort)(double, double) :
         {+[](double y, double) { return 1.05 * y; }, +[](double y, double t) { return y * std::exp(-0.3 * t); },
          +[](double y, double) { return std::min(y, 0.6); }, +[](double y, double t) { return y + 0.05 * t; }})
        for (const double restitution : {0.79, 0.6}) {
            const Diagnosis diagnosis = Drops{.restitution = restitution, .distort = distort}.diagnosis();
            for (const char* slip : {"set", "time shifted", "time jumps", "rate of time", "condition", "sign turned",
                                     "zero", "start", "scale", "unit", "time too short"})
                CHECK_MESSAGE(!warned_of(diagnosis.warnings, slip), (std::string(slip) + ": " + verdict_of(diagnosis)));
        }
}

TEST_CASE("a fit that is not thorough ends at what the baseline leads to") {
    Measurement late = Drops{}.measurement();
    for (double& time : late.records[2].time)
        time += 0.5;
    const auto runs_of = [&](bool thorough) {
        auto causes = choose_causes({"grav.g"});
        auto model = Model::make({floor_and_ball, "ball.toml"}, late.records, late.nuisances, *causes, closed_form);
        REQUIRE_MESSAGE(model, to_string(model.problems()));
        const Noise noise = first_noise(*model);
        std::vector<int> free;
        for (int k = 0; k < model->nuisances(); ++k)
            free.push_back(k);
        const auto baseline = diagnose::fit(*model, noise, model->start(), free);
        REQUIRE(baseline);
        const auto slope = slope_of(*model, noise, baseline->values, model->parameter_of(0), true);
        REQUIRE(slope);
        const int before = model->runs();
        refit_of({0}, *model, noise, *baseline, MatrixXd(*slope), thorough);
        return model->runs() - before;
    };
    CHECK(runs_of(false) > 0);
    CHECK(2 * runs_of(false) < runs_of(true));
}

TEST_CASE("two single numbers that were exchanged are told, and not those that differ by what scatters") {
    std::vector<Record> records;
    const std::vector<double> simulated{0.1, 0.2, 0.3, 0.4};
    for (const std::size_t k : {0, 2, 1, 3})
        records.push_back({.name = std::to_string(records.size()),
                           .condition = "",
                           .file = "r.csv",
                           .sets = {std::to_string(records.size())},
                           .time = {1},
                           .channels = {{.head = "rebound_m",
                                         .measure = "centre_of_mass_y",
                                         .unit = "m",
                                         .value = {simulated[k] + 0.001},
                                         .sigma = 1e-3,
                                         .take = Take::rebound}}});
    const Eigen::VectorXd predicted = Eigen::Map<const Eigen::VectorXd>(simulated.data(), 4);
    std::vector<std::vector<double>> sigma(4, {1e-3});
    const std::vector<Misread> told = exchanged_numbers(records, predicted, sigma);
    REQUIRE(told.size() == 1);
    CHECK(told[0].records == std::vector<std::size_t>{1, 2});
    CHECK_MESSAGE(
        told[0].problem.what.starts_with("rebound_m of '1' and of '2' agree with the simulation 100 times as "),
        told[0].problem.what);
    sigma.assign(4, {0.05});
    CHECK(exchanged_numbers(records, predicted, sigma).empty());
}

TEST_CASE("heights of the lowest point are told where the scene lets the ball go at such a height, too") {
    constexpr double radius = 0.01;
    std::vector<Record> records(1);
    Channel heights{.head = "height_m", .measure = "centre_of_mass_y", .unit = "m", .value = {}, .sigma = 1e-4};
    Eigen::VectorXd simulated(2000);
    for (int k = 0; k < 2000; ++k) {
        const double t = 1e-3 * k;
        records[0].time.push_back(t);
        heights.value.push_back(bouncing(0.5, 9.81, 0.8, t)); // of a ball let go at 0.5 m, its lowest point
        simulated[k] = bouncing(0.5 - radius, 9.81, 0.8, t) + radius;
    }
    records[0].channels = {heights};
    const auto told = lowest_point(records, simulated, radius);
    REQUIRE(told);
    CHECK_MESSAGE(told->what.find("where they are lowest") != std::string::npos, told->what);
    for (double& value : records[0].channels[0].value)
        value += 0.4 * radius;
    CHECK(!lowest_point(records, simulated, radius));
}

TEST_CASE("no agreement where most of what is missed comes of a few readings, or neighbours miss it alike") {
    const Diagnosis few = with([](std::vector<Record>& records) { // another thing was followed for a while
        for (std::size_t k = 50; k < 65; ++k)
            records[1].channels[0].value[k] = 0.01 + 1e-3 * static_cast<double>(k % 3);
    });
    CHECK_MESSAGE(few.decision.outcome == Outcome::cannot_decide, verdict_of(few));
    CHECK_MESSAGE(few.decision.reason.ends_with("most of it comes of a few, so no effect would show beside it"),
                  few.decision.reason);
    CHECK_MESSAGE(next_step(few).starts_with("First see to the readings of height_m in '0.8' about 0."),
                  next_step(few));
}

TEST_CASE("readings that hardly scatter keep the sigma stated, and without one they are refused") {
    Measurement simulated = Drops{.sigma = 0, .restitution = 0.8}.measurement();
    for (Record& record : simulated.records)
        record.channels[0].sigma = 2e-3;
    const Diagnosis kept = Drops::diagnosed(simulated);
    CHECK_MESSAGE(kept.decision.outcome == Outcome::consistent, verdict_of(kept));
    CHECK(kept.noise.used == about(2e-3));
    CHECK(warned(kept, "hardly any noise").size() == 1);
    for (Record& record : simulated.records)
        record.channels[0].sigma = 0;
    const auto refused = diagnose::diagnose({floor_and_ball, "ball.toml"}, simulated, closed_form);
    REQUIRE(!refused);
    CHECK_MESSAGE(refused.problems()[0].what.starts_with("height_m has no sigma, and hardly scatters"),
                  refused.problems()[0].what);
}

TEST_CASE("a restitution that nobody adjusted is asked before a name is believed, and heights of the lowest point") {
    Measurement measurement = Drops{.restitution = 0.78}.measurement(); // 0.8 in the scene
    measurement.nuisances.erase(measurement.nuisances.begin());
    measurement.causes = {"ins.gain", "grav.g", "rest.velocity"};
    const Diagnosis undeclared = Drops::diagnosed(measurement);
    CHECK((!names(undeclared.decision) || !undeclared.decision.sure));
    CHECK_MESSAGE(next_step(undeclared).starts_with("With pair.rubber-rubber.restitution = 0.78 in place of 0.8 only"),
                  next_step(undeclared));
    CHECK(next_step(undeclared).ends_with("give it as a nuisance (key = \"pair.rubber-rubber.restitution\")."));
    Measurement gain = Drops{.restitution = 0.8, .distort = [](double y, double) { return 1.02 * y; }}.measurement();
    gain.nuisances.erase(gain.nuisances.begin());
    const Diagnosis named = Drops::diagnosed(gain); // which no restitution explains
    CHECK_MESSAGE((named.decision.outcome == Outcome::named && named.decision.sure), verdict_of(named));

    Measurement low = Drops{}.measurement(); // let go 10 mm higher than the set says, which is of the lowest point
    for (Record& record : low.records)
        record.sets = {fmt::format("fill.0.position_m.1={}", std::stod(record.name) - 0.01)};
    const Diagnosis higher = Drops::diagnosed(low);
    CHECK_MESSAGE(next_step(higher).starts_with(
                      "With a radius, 10 mm, added to the heights at which it is let go only noise is left: first"),
                  next_step(higher));
}

TEST_CASE("a nuisance that had to go far is the first thing to find out about, unless a name brings it back") {
    Measurement measurement = Drops{.restitution = 0.665}.measurement(); // 0.8 +- 0.03 in the scene
    measurement.nuisances[0].spread = 0.03;
    const Diagnosis far = Drops::diagnosed(measurement);
    REQUIRE_MESSAGE(far.decision.outcome == Outcome::consistent, verdict_of(far));
    CHECK_MESSAGE(next_step(far).starts_with(
                      "First find out whether that can be: pair.rubber-rubber.restitution had to go from 0.8 to 0.6"),
                  next_step(far));
}

} // namespace test_misread
