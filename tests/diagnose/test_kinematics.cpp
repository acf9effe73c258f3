// What readings contradict by themselves, before anything is simulated.
#include "about.h"
#include "base/rng.h"
#include "diagnose/kinematics.h"
#include "floor_and_ball.h"
#include "scene/load.h"
#include "scene/settled.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_kinematics {

using namespace tumble;
using namespace tumble::diagnose;

namespace {

constexpr double place_sigma = 1e-3, speed_sigma = 5e-3; // m, m/s

scene::Scene ball(const std::string& more = "") {
    auto scene = scene::load_scene_text(std::string(test::floor_and_ball) + more, "ball.toml", {});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return std::move(*scene);
}

struct Sensors {
    double gain = 0, zero = 0, drift = 0; // of the velocity: -, m/s, m/s2
    double step = 0.01;                   // s
    double (*way)(double) = nullptr;
    double (*speed)(double) = nullptr;
    std::uint64_t seed = 1;

    [[nodiscard]] Record record(const std::string& axis = "x") const {
        Rng rng(seed);
        const auto normal = [&] {
            return std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(2 * std::numbers::pi * rng.uniform());
        };
        Record record;
        record.name = record.condition = "one";
        record.file = "one.csv";
        Channel place{.head = "place_m", .measure = "centre_of_mass_" + axis, .unit = "m", .value = {}};
        Channel fast{.head = "speed_m_s", .measure = "tracer:ball_v" + axis, .unit = "m_s", .value = {}};
        for (double t = 0; t < 2; t += step) {
            record.time.push_back(t);
            place.value.push_back(way(t) + place_sigma * normal());
            fast.value.push_back((1 + gain) * speed(t) + zero + drift * t + speed_sigma * normal());
        }
        record.channels = {place, fast};
        return record;
    }
};

Problems doubts_of(const Record& record, const scene::Scene& scene) {
    return kinematic_doubts(record, {place_sigma, speed_sigma}, scene);
}

std::string keys(const Problems& doubts) {
    std::string all;
    for (const Problem& doubt : doubts)
        all += doubt.key + ";";
    return all;
}

double swing(double t) {
    return 0.07 * std::sin(2 * std::numbers::pi * t / 0.25);
}
double swing_speed(double t) {
    return 0.07 * 2 * std::numbers::pi / 0.25 * std::cos(2 * std::numbers::pi * t / 0.25);
}
/// Comes up to nine tenths, and again.
double bouncing(double t) {
    double flight = std::sqrt(2 * 0.5 / 9.81), speed = 9.81 * flight;
    if (t < flight)
        return 0.5 - 0.5 * 9.81 * t * t;
    for (t -= flight; t > 2 * speed * 0.95 / 9.81; t -= 2 * speed / 9.81)
        speed *= 0.95;
    return 0.95 * speed * t - 0.5 * 9.81 * t * t;
}
/// The same with its second bounce from a camera that was knocked up by 90 mm.
double knocked(double t) {
    return bouncing(t) + (t > 0.9 ? 0.09 : 0);
}
double fall_speed(double) {
    return 0;
}

} // namespace

TEST_CASE("sensors that agree are not doubted") {
    const scene::Scene scene = ball();
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Problems doubts = doubts_of(Sensors{.way = swing, .speed = swing_speed, .seed = seed}.record(), scene);
        CHECK_MESSAGE(doubts.empty(), seed << " " << keys(doubts));
    }
}

TEST_CASE("a velocity whose sum is not the way is doubted, with what it has too much") {
    const scene::Scene scene = ball();
    const Problems zero = doubts_of(Sensors{.zero = 0.02, .way = swing, .speed = swing_speed}.record(), scene);
    REQUIRE(keys(zero) == "velocity against way;");
    CHECK(zero[0].file == "one.csv");
    CHECK(zero[0].what.find("runs away by +0.0") != std::string::npos);
    CHECK(keys(doubts_of(Sensors{.gain = 0.05, .way = swing, .speed = swing_speed}.record(), scene)) ==
          "velocity against way;");
    CHECK(keys(doubts_of(Sensors{.drift = 0.02, .way = swing, .speed = swing_speed}.record(), scene)) ==
          "velocity against way;");
}

TEST_CASE("a peak speed that amplitude and period cannot give is doubted") {
    const scene::Scene scene = ball();
    CHECK(keys(doubts_of(Sensors{.gain = -0.5, .way = swing, .speed = swing_speed}.record(), scene)) ==
          "velocity against way;peak speed;");
    CHECK(keys(doubts_of(Sensors{.gain = 0.8, .way = swing, .speed = swing_speed}.record(), scene)) ==
          "velocity against way;peak speed;");
}

TEST_CASE("no speed is larger than what a fall through the scene gives") {
    // 4 m high: sqrt(2 g 4 m) = 8.86 m/s.
    const scene::Scene scene = ball();
    const auto at = [&](double most) {
        Record record = Sensors{.way = swing, .speed = swing_speed}.record();
        record.channels[1].measure = "speed_max";
        for (std::size_t k = 7; k < 11; ++k)
            record.channels[1].value[k] = most;
        return keys(doubts_of(record, scene));
    };
    CHECK(at(8.8).empty());
    CHECK(at(8.95) == "speed;");
}

TEST_CASE("how a body is put in, its spin too, and walls that come to meet it make it faster") {
    const auto limit_beyond = [](const std::string& from, const std::string& to, const std::string& more,
                                 double speed) {
        std::string toml = test::floor_and_ball;
        toml.replace(toml.find(from), from.size(), to);
        const auto scene = scene::load_scene_text(toml + more, "ball.toml", {});
        REQUIRE_MESSAGE(scene, to_string(scene.problems()));
        Record record = Sensors{.way = swing, .speed = swing_speed}.record();
        record.channels[1].measure = "speed_max";
        for (std::size_t k = 7; k < 11; ++k)
            record.channels[1].value[k] = speed;
        return keys(doubts_of(record, *scene)).empty();
    };
    const std::string still = "velocity_m_s = [0, 0, 0]";
    CHECK(limit_beyond(still, "velocity_m_s = [3, 0, 0]", "", 9.3)); // root of 9 + 78.5
    CHECK(!limit_beyond(still, "velocity_m_s = [3, 0, 0]", "", 9.4));
    CHECK(limit_beyond(still, still + "\nangular_velocity_rad_s = [0, 0, 10]", "", 12));
    const std::string shaken =
        "[[wall.motion]]\nkind = \"harmonic\"\naxis = \"y\"\namplitude_m = 0.001\nfrequency_Hz = 40\n";
    CHECK(limit_beyond(still, still, shaken, 11)); // 0.25 m/s, restitution 0.8: 9 times as much
    CHECK(!limit_beyond(still, still, shaken, 11.3));
}

TEST_CASE("a body that comes up higher than before is doubted, unless a wall moves") {
    const auto of = [](double (*way)(double), const scene::Scene& scene) {
        Record record = Sensors{.way = way, .speed = fall_speed}.record("y");
        record.channels.pop_back();
        return keys(doubts_of(record, scene));
    };
    CHECK(of(bouncing, ball()).empty());
    CHECK(of(knocked, ball()) == "energy;");
    CHECK(of(knocked, ball("[[wall.motion]]\nkind = \"harmonic\"\naxis = \"y\"\namplitude_m = 0.001\n"
                           "frequency_Hz = 5\n"))
              .empty());
}

TEST_CASE("one wrong reading is no contradiction") {
    Record record = Sensors{.way = bouncing, .speed = fall_speed}.record("y");
    record.channels.pop_back();
    record.channels[0].value[50] -= 0.06; // on its way up
    CHECK(doubts_of(record, ball()).empty());
}

TEST_CASE("readings that are too rare for how a wall vibrates are doubted") {
    const auto shaken = [](double frequency) {
        return ball("[[wall.motion]]\nkind = \"harmonic\"\naxis = \"y\"\namplitude_m = 0.001\nfrequency_Hz = " +
                    std::to_string(frequency) + "\n");
    };
    const Record record = Sensors{.way = swing, .speed = swing_speed}.record(); // 100 a second
    CHECK(doubts_of(record, shaken(49)).empty());
    CHECK(keys(doubts_of(record, shaken(51))) == "aliasing;");
}

TEST_CASE("the phase of a vibration is counted from where it passes its middle") {
    const scene::Scene scene =
        ball("[[wall.motion]]\nkind = \"harmonic\"\naxis = \"y\"\namplitude_m = 0.001\nfrequency_Hz = 20\n"
             "phase_deg = 90\nstart_s = 0.3\n");
    const scene::Vibration found = scene::slowest_vibration(scene);
    CHECK(found.period == test::about(0.05, 1e-12));
    CHECK(found.from == test::about(0.3 - 0.05 / 4, 1e-12));
    CHECK(scene::slowest_vibration(ball()).period == 0);
}

} // namespace test_kinematics
