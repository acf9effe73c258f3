#include "experiment.h"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr double clock_sigma = 1e-3;    // s
constexpr double fine = 2.5e-4;         // s, grid of the filters
constexpr double light = 1.0 / 4;       // of the mass
constexpr double feet = 3, foot = 5e-3; // m, of the tripod
constexpr double pi = 3.14159265358979323846;

/// Heights on a fine grid, filtered by recursion for straight lines between its points.
std::vector<double> filtered(const Path& path, const Sensor& sensor, double end) {
    std::vector<double> y;
    for (double t = 0; t <= end + fine; t += fine)
        y.push_back(path.at(t));
    const auto smooth = [](const std::vector<double>& x, double tau, double from) {
        std::vector<double> out(x.size(), from);
        const double keep = std::exp(-fine / tau), ratio = tau / fine * (1 - keep);
        for (std::size_t k = 1; k < x.size(); ++k)
            out[k] = keep * out[k - 1] + (ratio - keep) * x[k - 1] + (1 - ratio) * x[k];
        return out;
    };
    if (sensor.low_pass > 0)
        y = smooth(y, sensor.low_pass, y.front());
    if (sensor.high_pass > 0) {
        const std::vector<double> slow = smooth(y, 1 / sensor.high_pass, 0);
        for (std::size_t k = 0; k < y.size(); ++k)
            y[k] -= slow[k];
    }
    return y;
}

std::vector<double> read(const Path& path, const Sensor& sensor, const std::vector<double>& times, double offset) {
    const bool filters = sensor.low_pass > 0 || sensor.high_pass > 0;
    const std::vector<double> grid = filters ? filtered(path, sensor, path.end()) : std::vector<double>{};
    std::vector<double> y;
    std::vector<double> real;
    for (const double time : times) {
        const double t = std::max(0.0, (time - offset) / (1 + sensor.rate));
        real.push_back((time - offset) / (1 + sensor.rate));
        if (filters) {
            const auto k = std::min(static_cast<std::size_t>(t / fine), grid.size() - 2);
            const double x = t / fine - static_cast<double>(k);
            y.push_back((1 - x) * grid[k] + x * grid[k + 1]);
        } else {
            y.push_back(path.at(t));
        }
    }
    if (sensor.clip > 0) {
        double lo = 1e300, hi = -1e300;
        for (double t = 0; t < path.end(); t += 1e-3) {
            lo = std::min(lo, path.at(t));
            hi = std::max(hi, path.at(t));
        }
        for (double& one : y)
            one = std::min(one, hi - sensor.clip * (hi - lo));
    }
    for (std::size_t k = 0; k < y.size(); ++k)
        y[k] = (1 + sensor.gain) * (y[k] + sensor.bend * y[k] * y[k]) + sensor.bias + sensor.drift * real[k];
    return y;
}

void drag(Truth& t, double density, double viscosity) {
    const auto add = [&](auto& body) {
        body.quadratic += 0.125 * pi * 0.44 * density * 4 * body.radius * body.radius;
        body.linear += 6 * pi * viscosity * body.radius;
    };
    add(t.ball);
    add(t.lane);
}

std::vector<Effect> listed() {
    return {
        {"drag.quadratic", true, 0.1, 20, true, true, true, true, [](Truth& t, double a) { drag(t, a, 0); }},
        {"drag.linear", true, 1e-3, 2, true, true, true, true, [](Truth& t, double a) { drag(t, 0, a); }},
        {"rest.velocity", true, 0.01, 0.4, true, true, false, false, [](Truth& t, double a) { t.ball.exponent += a; }},
        {"cohesion.work", true, 0.1, 100, true, true, false, true,
         [](Truth& t, double a) {
             t.ball.adhesion += a;
             t.lane.squeeze += feet * 2 * pi * a * foot / t.lane.mass;
         }},
        {"roll.coulomb", true, 1e-3, 0.3, true, false, true, false, [](Truth& t, double a) { t.lane.rolling += a; }},
        {"fric.weakening", true, 0.05, 1, true, false, true, true,
         [](Truth& t, double a) { t.lane.fast_friction *= 1 - a; }},
        {"grav.g", true, 1e-3, 0.05, false, true, true, true,
         [](Truth& t, double a) {
             t.ball.gravity *= 1 + a;
             t.lane.gravity *= 1 + a;
         }},
        {"grav.tilt_x", true, 0.02, 5, false, false, true, true,
         [](Truth& t, double a) { t.lane.slope += a * pi / 180; }},
        {"num.stiffness", true, 0.1, 3, false, true, false, false,
         [](Truth& t, double a) { t.ball.modulus *= std::exp(a); }},
        {"ins.clock_rate", true, 1e-3, 0.05, false, true, true, true, [](Truth& t, double a) { t.sensor.rate += a; }},
        {"ins.gain", true, 1e-3, 0.1, false, true, true, true, [](Truth& t, double a) { t.sensor.gain += a; }},
        {"ins.bias", true, 1e-4, 0.05, false, true, true, true, [](Truth& t, double a) { t.sensor.bias += a; }},
        {"ins.drift", true, 1e-4, 0.05, false, true, true, true, [](Truth& t, double a) { t.sensor.drift += a; }},
        {"ins.low_pass", true, 1e-3, 0.05, true, true, true, true, [](Truth& t, double a) { t.sensor.low_pass += a; }},
        {"ins.high_pass", true, 1e-2, 5, true, true, true, true, [](Truth& t, double a) { t.sensor.high_pass += a; }},
        {"ins.clipping", true, 2e-2, 0.9, true, true, true, true, [](Truth& t, double a) { t.sensor.clip += a; }},
    };
}

std::vector<Effect> unlisted() {
    return {
        {"sensor-bend", false, 1e-3, 0.2, false, true, true, true, [](Truth& t, double a) { t.sensor.bend += a; }},
        {"restitution-of-one-drop", false, 1e-3, 0.1, false, true, false, false,
         [](Truth& t, double a) { t.restitution[1] += a; }},
        {"plate-swings", false, 1e-3, 0.3, true, true, false, false,
         [](Truth& t, double a) {
             t.ball.plate_amplitude += a;
             t.ball.plate_frequency = 7.3;
             t.ball.plate_phase = 1;
         }},
        {"warms-up", false, 1e-3, 0.1, false, true, false, false, [](Truth& t, double a) { t.ball.by_impact += a; }},
        {"sticks", false, 1e-4, 0.02, true, true, false, false, [](Truth& t, double a) { t.ball.sticks += a; }},
        {"hollow-lane", false, 1e-4, 0.02, false, false, true, true, [](Truth& t, double a) { t.lane.hollow += a; }},
        {"slippery-patch", false, 0.01, 0.5, true, false, true, true, [](Truth& t, double a) { t.lane.patch += a; }},
        {"wind", false, 0.05, 10, false, false, true, true, [](Truth& t, double a) { t.lane.wind += a; }},
        {"rolling-by-speed", false, 1e-3, 0.1, true, false, true, false,
         [](Truth& t, double a) { t.lane.rolling_by_speed += a; }},
    };
}

std::vector<Effect> all_effects() {
    std::vector<Effect> all = listed();
    for (Effect& effect : unlisted())
        all.push_back(std::move(effect));
    return all;
}

Path path_in(const Setup& setup, const Truth& truth, std::size_t k) {
    const Trial& trial = setup.trials[k];
    const double duration = setup.duration + 0.05;
    if (setup.bench != Bench::drop) {
        Lane lane = truth.lane;
        lane.slope += trial.slope * pi / 180;
        if (setup.bench == Bench::slope)
            return path_down(lane, duration);
        return path_along(lane, trial.speed + (truth.speeds.empty() ? 0 : truth.speeds[k]), duration);
    }
    Ball ball = truth.ball;
    ball.restitution += truth.restitution.empty() ? 0 : truth.restitution[k];
    ball.mass *= trial.light ? light : 1;
    return path_of(ball, ball.radius + trial.height, duration);
}

} // namespace

std::vector<double> times_of(const Setup& setup) {
    std::vector<double> times;
    const double begin = setup.bench == Bench::lane ? 0.05 : 0; // a ball that is thrown is in the hand before
    for (int k = 0; k / setup.rate_hz < setup.duration; ++k)
        if (k / setup.rate_hz >= begin)
            times.push_back(k / setup.rate_hz);
    return times;
}

Eigen::VectorXd readings_of(const Setup& setup, const Truth& truth) {
    const std::vector<double> times = times_of(setup);
    const std::size_t records = setup.trials.size();
    Eigen::VectorXd all(static_cast<Eigen::Index>((setup.clock ? 2 : 1) * records * times.size()));
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < records; ++r) {
        const std::size_t done = truth.swapped && r < 2 ? 1 - r : r;
        for (const double y : read(path_in(setup, truth, done), truth.sensor, times, truth.offsets[r]))
            all[row++] = y / setup.sigma;
    }
    for (std::size_t r = 0; setup.clock && r < records; ++r)
        for (const double time : times)
            all[row++] = (time - truth.offsets[r]) / (1 + truth.sensor.rate) / clock_sigma;
    return all;
}

std::vector<Innocent> innocents_of(const Setup& setup) {
    std::vector<Innocent> all;
    if (setup.bench == Bench::drop)
        all.push_back({[](Truth& t, double a) { t.ball.restitution += a; }, 0.05});
    else
        all.push_back({[](Truth& t, double a) {
                           t.lane.fast_friction *= 1 + a / t.lane.friction;
                           t.lane.friction += a;
                       },
                       0.03});
    for (std::size_t r = 0; r < setup.trials.size(); ++r) {
        all.push_back({[r](Truth& t, double a) { t.offsets[r] += a; }, 5e-3});
        if (setup.bench == Bench::lane)
            all.push_back({[r](Truth& t, double a) { t.speeds[r] += a; }, 0.03});
    }
    return all;
}

bool shows(const Effect& effect, Bench bench) {
    return bench == Bench::drop ? effect.drops : bench == Bench::lane ? effect.lanes : effect.slopes;
}

std::string word_of(Bench bench) {
    return bench == Bench::drop ? "drop" : bench == Bench::lane ? "lane" : "slope";
}

Bench bench_of(const std::string& word) {
    return word == "lane" ? Bench::lane : word == "slope" ? Bench::slope : Bench::drop;
}

const std::vector<Effect>& effects() {
    static const std::vector<Effect> all = all_effects();
    return all;
}

const Effect* find_effect(const std::string& id) {
    for (const Effect& effect : effects())
        if (effect.id == id)
            return &effect;
    return nullptr;
}

} // namespace blind
