#include "about.h"
#include "base/rng.h"
#include "diagnose/data_doubts.h"
#include "diagnose/verdict.h"
#include "floor_and_ball.h"
#include "folder.h"
#include "gauss.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>

namespace test_sensors {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::bouncing;
using tumble::test::closed_form;
using tumble::test::floor_and_ball;

namespace {

constexpr double sigma = 2e-3; // m

/// Drops filmed by two cameras, of which the right one's scale is off and its shutter late.
struct Cameras {
    bool apart = true; // each column names the camera that read it
    double gain = 0;   // of the right one
    double late = 0;   // s, the right one

    [[nodiscard]] Measurement measurement() const {
        Rng rng(7);
        const auto normal = [&] { return tumble::test::gauss(rng); };
        Measurement all;
        all.title = "drops before two cameras";
        all.causes = {"grav.g", "sensor scale", "clock"};
        all.nuisances = {{.key = "pair.rubber-rubber.restitution", .instrument = "", .spread = 0.05}};
        for (const double height : {0.5, 0.8, 1.1, 1.5}) {
            Record record{.name = fmt::format("{} m", height),
                          .condition = fmt::format("{} m", height),
                          .file = "none.csv",
                          .sets = {fmt::format("fill.0.position_m.1={}", height)},
                          .time = {},
                          .channels = {}};
            for (int k = 0; k < 120; ++k)
                record.time.push_back(k / 120.0);
            for (const char* camera : {"left", "right"}) {
                const bool right = camera[0] == 'r';
                Channel channel{.head = std::string(camera) + "_m",
                                .measure = "centre_of_mass_y",
                                .unit = "m",
                                .value = {},
                                .sigma = sigma};
                channel.sensor = apart ? camera : "";
                for (const double t : record.time) {
                    const double y = bouncing(height, 9.81, 0.8, std::max(0.0, t - (right ? late : 0)));
                    channel.value.push_back((right ? 1 + gain : 1) * y + sigma * normal());
                }
                record.channels.push_back(std::move(channel));
            }
            all.records.push_back(std::move(record));
        }
        return all;
    }

    [[nodiscard]] Diagnosis diagnosis() const {
        auto result = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement(), closed_form);
        REQUIRE_MESSAGE(result, to_string(result.problems()));
        return std::move(*result);
    }
};

std::string named(const Diagnosis& diagnosis) {
    std::string all = diagnosis.decision.outcome == Outcome::named ? "named:" : "";
    for (const int k : diagnosis.decision.causes)
        all += " " + diagnosis.causes[static_cast<std::size_t>(k)].id;
    return all;
}

const std::string two_columns = R"(title = "two cameras"
[[nuisance]]
instrument = "gain"
sensor = "left"
spread = 0.01
[[series]]
name = "low"
file = "low.csv"
[[series.column]]
head = "left"
measure = "centre_of_mass_y"
sensor = "left"
[[series.column]]
head = "right"
measure = "centre_of_mass_y"
sensor = "right"
)";

std::string without(std::string text, const std::string& what) {
    text.erase(text.find(what), what.size());
    return text;
}

/// What is wrong with it; the measurement itself where nothing is.
Result<Measurement> loaded(const std::string& toml) {
    const test::Folder folder;
    test::put(folder.path / "m.toml", toml);
    std::string csv = "time_s,left_mm,right_mm\n";
    for (int k = 0; k < 10; ++k)
        csv += fmt::format("{},{},{}\n", 0.01 * k, 200 - 0.5 * k * k, 200.3 - 0.49 * k * k);
    test::put(folder.path / "low.csv", csv);
    return load_measurement(folder.path / "m.toml");
}

} // namespace

TEST_CASE("what is wrong with one of two sensors is named with it, in its own size") {
    const Diagnosis diagnosis = Cameras{.gain = 0.004}.diagnosis();
    REQUIRE_MESSAGE(named(diagnosis) == "named: ins.gain of right", verdict_of(diagnosis));
    const Refit& best = *diagnosis.decision.best;
    CHECK(std::abs(best.amplitude[0] - 0.004) < 3 * best.error[0]);
    CHECK(best.error[0] < 0.001);
    CHECK(named(Cameras{.late = 0.004}.diagnosis()) == "named: ins.clock_offset of right");
    CHECK(Cameras{}.diagnosis().decision.outcome == Outcome::consistent);
}

TEST_CASE("of one sensor that read both columns, what only one of them shows is none of the known causes") {
    const Diagnosis diagnosis = Cameras{.apart = false, .gain = 0.008}.diagnosis();
    CHECK_MESSAGE(diagnosis.decision.outcome == Outcome::none_known, verdict_of(diagnosis));
}

TEST_CASE("a nuisance of one sensor's scale leaves the other's to be named") {
    Cameras cameras{.gain = 0.004};
    Measurement measurement = cameras.measurement();
    measurement.nuisances.push_back({.key = "", .instrument = "gain", .spread = 0.02, .sensor = "left"});
    const auto found = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement, closed_form);
    REQUIRE(found);
    CHECK_MESSAGE(named(*found) == "named: ins.gain of right", verdict_of(*found));
    measurement.nuisances.back().sensor = "right";
    const auto innocent = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement, closed_form);
    REQUIRE(innocent);
    CHECK_MESSAGE(innocent->decision.outcome == Outcome::consistent, verdict_of(*innocent));
    CHECK(innocent->nuisances.back().name == "gain of right");
    CHECK(innocent->nuisances.back().value == about(0.004, 0.2));
}

TEST_CASE("two columns of one measure that differ by more than they scatter are told, with the factor between them") {
    const auto warned = [](double gain, const char* sensor) {
        Measurement measurement = Cameras{.apart = false, .gain = gain}.measurement();
        Record& record = measurement.records[0];
        record.channels[1].sensor = sensor;
        Problems warnings;
        doubt_record(record, warnings);
        const auto found = std::find_if(warnings.begin(), warnings.end(),
                                        [](const Problem& warning) { return warning.key == "columns differ"; });
        return found == warnings.end() ? "" : found->what;
    };
    const std::string told = warned(0.05, "");
    REQUIRE(told.find("the best factor between them is ") != std::string::npos);
    CHECK(std::stod(told.substr(told.rfind(' '))) == about(1.05, 2e-3));
    CHECK(warned(0, "").empty());
    CHECK(warned(0.05, "right").empty()); // two instruments: what is wrong with one is a cause
}

TEST_CASE("a record that lasts a hundred times as long as its scene has its time in other units") {
    Measurement measurement = Cameras{}.measurement();
    for (double& time : measurement.records[1].time)
        time *= 1000;
    const auto refused = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement, closed_form);
    REQUIRE(!refused);
    CHECK(refused.problems()[0].what.starts_with("'0.8 m' lasts"));
    CHECK(refused.problems()[0].what.ends_with("milliseconds read as seconds?"));
}

TEST_CASE("sensors are read from a file, in all columns or in none") {
    const auto read = loaded(two_columns);
    REQUIRE_MESSAGE(read, to_string(read.problems()));
    CHECK(read->records[0].channels[1].sensor == "right");
    CHECK(read->nuisances[0].sensor == "left");
    const auto refused = [](const std::string& toml) {
        const auto wrong = loaded(toml);
        REQUIRE(!wrong);
        return to_string(wrong.problems()[0]);
    };
    CHECK(refused(without(two_columns, "sensor = \"right\"\n")).find("some columns name their sensor (left)") !=
          std::string::npos);
    std::string other = two_columns;
    other.replace(other.find("\"left\""), 6, "\"middle\"");
    CHECK(refused(other).find("no column is of the sensor 'middle'") != std::string::npos);
    CHECK(refused(other).find("write one of left, right") != std::string::npos);
}

} // namespace test_sensors
