// Records that agree with the simulation once they are read otherwise than their files say.
#include "about.h"
#include "diagnose/considered.h"
#include "diagnose/fit_doubts.h"
#include "diagnose/record_slips.h"
#include "diagnose/refit.h"
#include "diagnose/verdict.h"
#include "drops.h"

#include <algorithm>
#include <cmath>

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
template <class Slip> Diagnosis with(Slip slip) {
    Measurement measurement = Drops{}.measurement();
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
    CHECK_MESSAGE(told[0].starts_with("'0.8' agrees with the simulation "), told[0]);
    CHECK_MESSAGE(told[0].ends_with(" times as well if it is of the condition of '1.1'"), told[0]);
    CHECK_MESSAGE(told[1].ends_with("if it is of the condition of '0.8'"), told[1]);
    CHECK_MESSAGE(next_step(swapped).starts_with("First see to the files: '0.8' agrees"), next_step(swapped));
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

TEST_CASE("what effects do is no slip: restitution, drag, gain and clipping leave no such warning") {
    for (double (*distort)(double, double) :
         {+[](double y, double) { return 1.05 * y; }, +[](double y, double t) { return y * std::exp(-0.3 * t); },
          +[](double y, double) { return std::min(y, 0.6); }, +[](double y, double t) { return y + 0.05 * t; }})
        for (const double restitution : {0.79, 0.6}) {
            const Diagnosis diagnosis = Drops{.restitution = restitution, .distort = distort}.diagnosis();
            for (const char* slip : slips)
                CHECK_MESSAGE(!warned_of(diagnosis.warnings, slip), slip);
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
    const Problems told = exchanged_numbers(records, predicted, sigma);
    REQUIRE(told.size() == 1);
    CHECK_MESSAGE(told[0].what.starts_with("rebound_m of '1' and of '2' agree with the simulation 100 times as well"),
                  told[0].what);
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
