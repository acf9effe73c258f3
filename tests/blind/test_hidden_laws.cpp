// Laws and motions of the solver hidden in closed forms of their own, and named through the solver; and every cause at
// its null value, which is the baseline to the last bit.
#include "base/rng.h"
#include "base/text.h"
#include "diagnose/verdict.h"
#include "laboratory.h"
#include "scene/load.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <set>

using namespace blind;

namespace hidden_laws {

using namespace tumble;
using namespace tumble::diagnose;

namespace {

constexpr double pi = std::numbers::pi;

double gauss(Rng& rng) {
    return std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(2 * pi * rng.uniform());
}

/// What is read of a path at `rate` readings a second, with scatter.
Record read_of(const std::string& name, std::vector<std::string> sets, const std::string& measure, double sigma,
               double rate, double duration, Rng& rng, const std::function<double(double)>& path) {
    Record record{
        .name = name, .condition = name, .file = "none.csv", .sets = std::move(sets), .time = {}, .channels = {}};
    diagnose::Channel channel{.head = "way_m", .measure = measure, .unit = "m", .value = {}, .sigma = sigma};
    for (int k = 0; k < rate * duration; ++k) {
        record.time.push_back(k / rate);
        channel.value.push_back(path(record.time.back()) + sigma * gauss(rng));
    }
    record.channels.push_back(std::move(channel));
    return record;
}

std::set<std::string> ids_of(const Diagnosis& diagnosis) {
    std::set<std::string> ids;
    for (const int k : diagnosis.decision.causes)
        ids.insert(diagnosis.causes[static_cast<std::size_t>(k)].id);
    return ids;
}

Diagnosis diagnosed_as(const SceneText& scene, const Measurement& measurement) {
    auto result = diagnose::diagnose(scene, measurement, on_the_solver);
    REQUIRE_MESSAGE(result, to_string(result.problems()));
    return std::move(*result);
}

void check_found(const Diagnosis& diagnosis, const std::string& id, double amplitude) {
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK_MESSAGE(diagnosis.decision.sure, verdict_of(diagnosis));
    CHECK_MESSAGE(ids_of(diagnosis) == std::set<std::string>{id}, verdict_of(diagnosis));
    const Refit& best = *diagnosis.decision.best;
    CHECK_MESSAGE(std::abs(best.amplitude[0] - amplitude) < 4 * best.error[0], verdict_of(diagnosis));
}

constexpr double radius = 0.05; // m, of the ball on the lane

/// A ball let go rolling that slows down as exp(-5/7 g tau t / R): v / k (1 - exp(-k t)), of every mass the same.
Record rolled_out(double speed, double from, double mass, double tau, Rng& rng) {
    const double k = 5.0 / 7 * 9.81 * tau / radius;
    const std::string name = fmt::format("{} m/s from {} m, {} kg", speed, from, mass);
    return read_of(name,
                   {fmt::format("fill.0.velocity_m_s.0={}", speed),
                    fmt::format("fill.0.angular_velocity_rad_s.2={}", -speed / radius),
                    fmt::format("fill.0.position_m.0={}", from), fmt::format("body.ball.mass_kg={}", mass)},
                   "centre_of_mass_x", 2e-3, 60, 2, rng,
                   [=](double t) { return from + speed / k * (1 - std::exp(-k * t)); });
}

Measurement of_rolling(std::vector<Record> records) {
    Measurement all;
    all.nuisances = {{.key = "fill.0.velocity_m_s.0", .instrument = "", .per_record = true, .spread = 0.03},
                     {.key = "", .instrument = "clock_offset", .per_record = true, .spread = 0.005}};
    all.records = std::move(records);
    return all;
}

const std::string plate = R"(title = "a ball that rests on a plate"
duration_s = 1
time_step_s = 1e-5
[domain]
lo_m = [-0.1, -0.1, -0.1]
hi_m = [0.1, 0.1, 0.1]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 1e9
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.3
friction = 0.4
[body.ball]
radius_mm = 10
material = "glass"
[[fill]]
body = "ball"
count = 1
position_m = [0, 0.01, 0]
[[wall]]
name = "plate"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "glass"
[[wall.motion]]
kind = "harmonic"
axis = "y"
amplitude_m = 0.001
frequency_Hz = 10
phase_deg = 90
)";

/// The plate goes at no more than 4 m/s2, so the ball stays on it: `more` is what is not in the scene, by the angle.
Measurement of_plate(double drift, double sigma, const std::function<double(double)>& more) {
    Rng rng(5);
    Measurement all;
    all.causes = {"excitation", "sensor scale", "clock"};
    all.nuisances = {{.key = "", .instrument = "bias", .spread = 1e-4}};
    for (const double f : {10.0, 7.0})
        all.records.push_back(read_of(shortest(f) + " Hz", {"wall.0.motion.0.frequency_Hz=" + shortest(f)},
                                      "centre_of_mass_y", sigma, 400, 0.9, rng, [&](double t) {
                                          const double angle = 2 * pi * f * (t + 0.5 * drift * t * t);
                                          return 0.01 + 1e-3 * (std::cos(angle) - 1 + more(angle));
                                      }));
    return all;
}

/// What a logger on the tripod sums up while it slides from rest at this angle, down towards +x: both components of its
/// velocity. It sits turned by `askew` about z; what it feels, a - g, is turned back by that, and g is added where it
/// believes it to be.
Record logged(double degrees, double friction, double askew, Rng& rng) {
    const double angle = degrees * pi / 180, g = 9.81;
    const double gx = g * std::sin(angle), gy = -g * std::cos(angle);
    const double ax = gx + (degrees > 0 ? friction : -friction) * gy;
    const double c = std::cos(askew), s = std::sin(askew);
    const double believed[2] = {c * (ax - gx) - s * gy + gx, -s * (ax - gx) - c * gy + gy};
    Record record = read_of(fmt::format("{} deg", degrees), {fmt::format("gravity_m_s2=[{:.9f}, {:.9f}, 0]", gx, gy)},
                            "tracer:tripod_summed_vx", 3e-2, 100, 1, rng, [&](double t) { return believed[0] * t; });
    diagnose::Channel upwards = record.channels[0];
    upwards.measure = "tracer:tripod_summed_vy";
    for (std::size_t k = 0; k < record.time.size(); ++k)
        upwards.value[k] = believed[1] * record.time[k] + upwards.sigma * gauss(rng);
    record.channels.push_back(std::move(upwards));
    for (diagnose::Channel& channel : record.channels) {
        channel.head = "v_m_s";
        channel.unit = "m_s";
    }
    return record;
}

Measurement of_logger(double askew) {
    Rng rng(17);
    Measurement all;
    all.nuisances = {{.key = "pair.plastic-board.friction", .instrument = "", .spread = 0.03}};
    for (const double degrees : {18.0, -18.0, 24.0, -24.0})
        all.records.push_back(logged(degrees, 0.28, askew, rng));
    return all;
}

} // namespace

TEST_CASE("gravity that leaks into an accelerometer which sits askew is named from the velocities it sums up") {
    const Diagnosis upright = diagnosed_as(scene_of(Bench::slope), of_logger(0));
    CHECK_MESSAGE(upright.decision.outcome == Outcome::consistent, verdict_of(upright));
    // What is felt has no component along z at all, so that a lean towards z shows by its square only.
    check_found(diagnosed_as(scene_of(Bench::slope), of_logger(0.4 * pi / 180)), "ins.gravity_leak_x", 0.4);
}

TEST_CASE("rolling resistance that grows with speed is named where masses and places differ: "
          "drag would go by mass, a high pass by place") {
    Rng rng(11);
    const double tau = 5e-4;
    check_found(diagnosed_as(scene_of(Bench::lane),
                             of_rolling({rolled_out(1, 0, 0.5, tau, rng), rolled_out(-1, 4, 0.15, tau, rng),
                                         rolled_out(0.6, -4, 0.15, tau, rng), rolled_out(-0.6, 0, 0.5, tau, rng)})),
                "roll.viscous", tau);
}

TEST_CASE(
    "with one mass and one place it is one answer with viscous drag and a high pass, and they are told together") {
    Rng rng(12);
    const double tau = 5e-4;
    const Diagnosis diagnosis = diagnosed_as(
        scene_of(Bench::lane), of_rolling({rolled_out(1, 0, 0.5, tau, rng), rolled_out(-1, 0, 0.5, tau, rng),
                                           rolled_out(0.6, 0, 0.5, tau, rng)}));
    CHECK_MESSAGE((diagnosis.decision.outcome == Outcome::ambiguous || diagnosis.decision.one_class),
                  verdict_of(diagnosis));
    for (const char* id : {"roll.viscous", "drag.linear"})
        CHECK_MESSAGE(ids_of(diagnosis).contains(id), verdict_of(diagnosis));
}

TEST_CASE("a second harmonic of a plate is named, either part of it, and so is a frequency that drifts") {
    const SceneText scene{plate, "plate.toml"};
    // The plate's angle is a quarter ahead: 2 (angle + 90 deg) = 2 angle + 180 deg.
    check_found(diagnosed_as(scene, of_plate(0, 6e-5, [](double angle) { return -0.05 * std::sin(2 * angle); })),
                "exc.harmonic", 0.05);
    check_found(diagnosed_as(scene, of_plate(0, 6e-5, [](double angle) { return -0.05 * (std::cos(2 * angle) - 1); })),
                "exc.harmonic_ahead", 0.05);
    check_found(diagnosed_as(scene, of_plate(0.004, 2.5e-5, [](double) { return 0.0; })), "exc.drift", 0.004);
}

TEST_CASE("every cause that extends a scene is the scene itself at its null value, bit for bit") {
    const SceneText lane = scene_of(Bench::lane);
    const std::vector<scene::Override> brief{{"duration_s=0.05"}, {"fill.0.velocity_m_s=[1.0, -0.2, 0.0]"}};
    const auto rolled = scene::load_scene_text(lane.toml, lane.file, brief);
    const auto shaken = scene::load_scene_text(plate, "plate.toml", {{"duration_s=0.05"}});
    REQUIRE_MESSAGE(rolled, to_string(rolled.problems()));
    REQUIRE_MESSAGE(shaken, to_string(shaken.problems()));
    for (scene::Scene scene : {*rolled, *shaken}) {
        scene.observe.measures = {"centre_of_mass_x", "centre_of_mass_y", "kinetic_energy"};
        scene.observe.every = 1e-3;
        const auto baseline = on_the_solver(scene);
        REQUIRE_MESSAGE(baseline, to_string(baseline.problems()));
        for (const Cause& cause : all_causes()) {
            if (!cause.physical())
                continue;
            scene::Scene extended = scene;
            cause.extend(extended, 0);
            const auto same = on_the_solver(extended);
            REQUIRE_MESSAGE(same, cause.id);
            CHECK_MESSAGE(same->values == baseline->values, cause.id);
        }
    }
}

} // namespace hidden_laws
