#include "experiment.h"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr double clock_sigma = 1e-3; // s
constexpr double fine = 2.5e-4;      // s, grid of the filters
constexpr double light = 1.0 / 4;    // of the mass

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

std::vector<Effect> all_effects() {
    return {
        {"drag.quadratic", true, 0.1, 20, true,
         [](Truth& t, double a) {
             t.ball.quadratic += 0.125 * 3.14159265358979323846 * 0.44 * a * 4 * t.ball.radius * t.ball.radius;
         }},
        {"drag.linear", true, 1e-3, 2, true,
         [](Truth& t, double a) { t.ball.linear += 6 * 3.14159265358979323846 * a * t.ball.radius; }},
        {"rest.velocity", true, 0.01, 0.4, true, [](Truth& t, double a) { t.ball.exponent += a; }},
        {"grav.g", true, 1e-3, 0.05, false, [](Truth& t, double a) { t.ball.gravity *= 1 + a; }},
        {"num.stiffness", true, 0.1, 3, false, [](Truth& t, double a) { t.ball.modulus *= std::exp(a); }},
        {"ins.clock_rate", true, 1e-3, 0.05, false, [](Truth& t, double a) { t.sensor.rate += a; }},
        {"ins.gain", true, 1e-3, 0.1, false, [](Truth& t, double a) { t.sensor.gain += a; }},
        {"ins.bias", true, 1e-4, 0.05, false, [](Truth& t, double a) { t.sensor.bias += a; }},
        {"ins.drift", true, 1e-4, 0.05, false, [](Truth& t, double a) { t.sensor.drift += a; }},
        {"ins.low_pass", true, 1e-3, 0.05, true, [](Truth& t, double a) { t.sensor.low_pass += a; }},
        {"ins.high_pass", true, 1e-2, 5, true, [](Truth& t, double a) { t.sensor.high_pass += a; }},
        {"ins.clipping", true, 2e-2, 0.9, true, [](Truth& t, double a) { t.sensor.clip += a; }},
        {"sensor-bend", false, 1e-3, 0.2, false, [](Truth& t, double a) { t.sensor.bend += a; }},
        {"restitution-of-one-drop", false, 1e-3, 0.1, false, [](Truth& t, double a) { t.restitution[1] += a; }},
        {"plate-swings", false, 1e-3, 0.3, true,
         [](Truth& t, double a) {
             t.ball.plate_amplitude += a;
             t.ball.plate_frequency = 7.3;
             t.ball.plate_phase = 1;
         }},
        {"warms-up", false, 1e-3, 0.1, false, [](Truth& t, double a) { t.ball.by_impact += a; }},
        {"sticks", false, 1e-4, 0.02, true, [](Truth& t, double a) { t.ball.sticks += a; }},
    };
}

} // namespace

std::vector<double> times_of(const Setup& setup) {
    std::vector<double> times;
    for (int k = 0; k / setup.rate_hz < setup.duration; ++k)
        times.push_back(k / setup.rate_hz);
    return times;
}

Eigen::VectorXd readings_of(const Setup& setup, const Truth& truth) {
    const std::vector<double> times = times_of(setup);
    const std::size_t records = setup.drops.size();
    Eigen::VectorXd all(static_cast<Eigen::Index>((setup.clock ? 2 : 1) * records * times.size()));
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < records; ++r) {
        const std::size_t done = truth.swapped && r < 2 ? 1 - r : r;
        Ball ball = truth.ball;
        ball.restitution += truth.restitution.empty() ? 0 : truth.restitution[done];
        ball.mass *= setup.drops[done].light ? light : 1;
        const Path path = path_of(ball, ball.radius + setup.drops[done].height, setup.duration + 0.05);
        for (const double y : read(path, truth.sensor, times, truth.offsets[r]))
            all[row++] = y / setup.sigma;
    }
    for (std::size_t r = 0; setup.clock && r < records; ++r)
        for (const double time : times)
            all[row++] = (time - truth.offsets[r]) / (1 + truth.sensor.rate) / clock_sigma;
    return all;
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
