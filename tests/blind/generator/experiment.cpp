#include "experiment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

namespace blind {

namespace {

constexpr double clock_sigma = 1e-3;    // s
constexpr double fine = 2.5e-4;         // s, grid of the filters
constexpr double feet = 3, foot = 5e-3; // m, of the tripod
constexpr double reach = 25e-3;         // m, of its circle
constexpr double pi = 3.14159265358979323846;
constexpr std::size_t most_remembered = 300;

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

/// The largest magnitude of a path until then, looked for every millisecond.
double largest_of(const Path& path, double end) {
    double most = 0;
    for (double t = 0; t <= end; t += 1e-3)
        most = std::max(most, std::abs(path.at(t)));
    return most;
}

std::vector<double> read(const Path& path, const Sensor& sensor, const std::vector<double>& times, double offset,
                         double largest) {
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
    for (double& one : y)
        if (const double limit = (1 - sensor.clip) * largest; sensor.clip > 0 && std::abs(one) > limit)
            one = std::copysign(limit, one);
    for (std::size_t k = 0; k < y.size(); ++k)
        y[k] = (1 + sensor.gain) * (y[k] + sensor.bend * y[k] * y[k]) + sensor.bias + sensor.drift * real[k];
    for (std::size_t k = 0; sensor.shake != 0 && k < y.size(); ++k)
        y[k] += sensor.shake * std::sin(2 * pi * 7.3 * times[k] + 1);
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

constexpr unsigned drops = on(Bench::drop), lanes = on(Bench::lane), slopes = on(Bench::slope), rolls = on(Bench::roll),
                   throws = on(Bench::oblique), spins = on(Bench::spin), plates = on(Bench::plate),
                   in_open_air = drops | lanes | slopes | rolls | throws, bounces = drops | throws | plates,
                   all_but_spins = in_open_air | plates, all = all_but_spins | spins;

std::vector<Effect> listed() {
    return {
        {"drag.quadratic", true, 0.1, 20, true, in_open_air, [](Truth& t, double a) { drag(t, a, 0); }},
        {"drag.linear", true, 1e-3, 2, true, in_open_air, [](Truth& t, double a) { drag(t, 0, a); }},
        {"rest.velocity", true, 0.01, 0.4, true, bounces, [](Truth& t, double a) { t.ball.exponent += a; }},
        {"cohesion.work", true, 0.1, 100, true, slopes | bounces,
         [](Truth& t, double a) {
             t.ball.adhesion += a;
             t.lane.squeeze += feet * 2 * pi * a * foot / t.lane.mass;
         }},
        {"roll.coulomb", true, 1e-3, 0.3, true, lanes | rolls | throws,
         [](Truth& t, double a) { t.lane.rolling += a; }},
        {"roll.viscous", true, 1e-4, 0.1, true, lanes | rolls, [](Truth& t, double a) { t.lane.rolling_time += a; }},
        {"fric.weakening", true, 0.05, 1, true, lanes | slopes | throws | spins,
         [](Truth& t, double a) { t.lane.fast_friction *= 1 - a; }},
        {"grav.g", true, 1e-3, 0.05, false, all_but_spins & ~rolls,
         [](Truth& t, double a) {
             t.ball.gravity *= 1 + a;
             t.lane.gravity *= 1 + a;
         }},
        {"grav.tilt_x", true, 0.02, 5, false, in_open_air & ~drops,
         [](Truth& t, double a) { t.lane.slope += a * pi / 180; }},
        {"mass.density", true, 0.05, 1, false, bounces, [](Truth& t, double a) { t.ball.mass *= std::exp(a); }},
        {"num.stiffness", true, 0.1, 3, false, bounces,
         [](Truth& t, double a) {
             t.ball.modulus *= std::exp(a);
             t.ball.shear *= std::exp(a);
         }},
        {"exc.gain", true, 0.01, 1, false, plates, [](Truth& t, double a) { t.ball.shaken *= 1 + a; }},
        {"exc.frequency", true, 1e-3, 0.05, false, plates, [](Truth& t, double a) { t.ball.shaken_at *= 1 + a; }},
        {"ins.clock_rate", true, 1e-3, 0.05, false, all & ~rolls, [](Truth& t, double a) { t.sensor.rate += a; }},
        {"ins.gain", true, 1e-3, 0.1, false, all & ~rolls, [](Truth& t, double a) { t.sensor.gain += a; }},
        {"ins.bias", true, 1e-4, 1, false, all, [](Truth& t, double a) { t.sensor.bias += a; }},
        {"ins.drift", true, 1e-4, 1, false, all & ~rolls, [](Truth& t, double a) { t.sensor.drift += a; }},
        {"ins.low_pass", true, 1e-3, 0.05, true, all, [](Truth& t, double a) { t.sensor.low_pass += a; }},
        {"ins.high_pass", true, 1e-2, 5, true, all, [](Truth& t, double a) { t.sensor.high_pass += a; }},
        {"ins.clipping", true, 2e-2, 0.9, true, all, [](Truth& t, double a) { t.sensor.clip += a; }},
    };
}

std::vector<Effect> unlisted() {
    return {
        {"sensor-bend", false, 1e-3, 0.2, false, all, [](Truth& t, double a) { t.sensor.bend += a; }},
        {"camera-shakes", false, 1e-3, 0.5, true, all, [](Truth& t, double a) { t.sensor.shake += a; }},
        {"restitution-of-one-drop", false, 1e-3, 0.1, false, bounces,
         [](Truth& t, double a) { t.one_restitution += a; }},
        {"friction-of-one-run", false, 1e-2, 0.5, false, lanes | slopes | throws | spins,
         [](Truth& t, double a) { t.one_friction += a; }},
        {"dust-in-one-run", false, 1e-3, 0.1, true, rolls | lanes, [](Truth& t, double a) { t.one_rolling += a; }},
        {"two-exchanged", false, 1, 1, true, all, [](Truth& t, double) { t.swapped = true; }, true},
        {"plate-swings", false, 1e-3, 0.3, true, drops | throws,
         [](Truth& t, double a) {
             t.ball.plate_amplitude += a;
             t.ball.plate_frequency = 7.3;
             t.ball.plate_phase = 1;
         }},
        {"warms-up", false, 1e-3, 0.1, false, bounces, [](Truth& t, double a) { t.ball.by_impact += a; }},
        {"restitution-scatters", false, 3e-3, 0.2, true, bounces, [](Truth& t, double a) { t.ball.rough += a; }},
        {"sticks", false, 1e-4, 0.02, true, drops, [](Truth& t, double a) { t.ball.sticks += a; }},
        {"spin-lifts", false, 1e-3, 0.3, false, throws, [](Truth& t, double a) { t.ball.magnus += a; }},
        {"hollow-lane", false, 1e-4, 0.02, false, lanes | slopes | rolls,
         [](Truth& t, double a) { t.lane.hollow += a; }},
        {"slippery-patch", false, 0.01, 0.5, true, lanes | slopes, [](Truth& t, double a) { t.lane.patch += a; }},
        {"ground-shakes", false, 0.1, 9, true, lanes | slopes | spins, [](Truth& t, double a) { t.lane.shakes += a; }},
        {"wind", false, 0.05, 10, false, lanes | slopes | rolls, [](Truth& t, double a) { t.lane.wind += a; }},
        {"film", false, 0.01, 2, true, spins | slopes, [](Truth& t, double a) { t.lane.film += a; }},
    };
}

std::vector<Effect> all_effects() {
    std::vector<Effect> every = listed();
    for (Effect& effect : unlisted())
        every.push_back(std::move(effect));
    return every;
}

/// Ball and lane of one trial.
Truth in_trial(const Setup& setup, Truth truth, std::size_t k) {
    const Trial& trial = setup.trials[k];
    truth.ball.mass *= trial.mass;
    truth.ball.shaken *= trial.shaken;
    truth.ball.throws = 100 * truth.ball.throws + k;
    truth.lane.mass *= trial.mass;
    truth.lane.squeeze /= trial.mass;
    truth.lane.slope += trial.slope * pi / 180;
    if (k == 1) {
        truth.ball.restitution += truth.one_restitution;
        truth.lane.friction *= 1 + truth.one_friction;
        truth.lane.fast_friction *= 1 + truth.one_friction;
        truth.lane.rolling += truth.one_rolling;
    }
    return truth;
}

/// Of every channel, of a truth that is the trial's own.
std::vector<Path> ran(const Setup& setup, const Trial& trial, const Truth& truth, double speed) {
    const double duration = trial.lasts * setup.duration + 0.05;
    switch (setup.bench) {
    case Bench::drop:
    case Bench::plate:
        return {path_of(truth.ball, truth.ball.radius + trial.height, duration)};
    case Bench::lane:
        return {path_along(truth.lane, speed, 0, duration)};
    case Bench::slope:
        return {path_down(truth.lane, duration)};
    case Bench::roll: // its spin is what the scene has; a faster throw slips a little
        return {path_along(truth.lane, speed, trial.speed, duration)};
    case Bench::spin:
        return {spin_of(truth.lane, trial.spin, foot, reach, duration)};
    case Bench::oblique:
        break;
    }
    Flight flight = flight_of(truth.ball, truth.lane, truth.ball.radius + trial.height, speed, duration);
    return {std::move(flight.along), std::move(flight.height)};
}

template <class Plain> void append(std::string& key, const Plain& plain) {
    static_assert(std::is_trivially_copyable_v<Plain> && sizeof(Plain) % sizeof(double) == 0);
    key.append(reinterpret_cast<const char*>(&plain), sizeof plain);
}

/// The same, remembered by every number that it depends on: what only clocks and sensors change is not run again.
const std::vector<Path>& paths_in(const Setup& setup, const Truth& all_trials, std::size_t k) {
    static std::map<std::string, std::vector<Path>> known;
    const Trial& trial = setup.trials[k];
    const Truth truth = in_trial(setup, all_trials, k);
    const double speed = trial.speed + (truth.speeds.empty() ? 0 : truth.speeds[k]);
    std::string key;
    append(key, truth.ball);
    append(key, truth.lane);
    append(key, trial);
    append(key, speed);
    append(key, setup.duration);
    append(key, static_cast<double>(setup.bench));
    if (known.size() >= most_remembered)
        known.clear();
    const auto [found, added] = known.try_emplace(key);
    if (added)
        found->second = ran(setup, trial, truth, speed);
    return found->second;
}

} // namespace

std::vector<Channel> channels_of(Bench bench) {
    const Channel way{"way", "mm", 1000, "centre_of_mass_x"}, height{"height", "mm", 1000, "centre_of_mass_y"};
    if (bench == Bench::drop || bench == Bench::plate)
        return {height};
    if (bench == Bench::oblique)
        return {way, height};
    if (bench == Bench::spin)
        return {{"spin", "rad_s", 1, "angular_speed_max"}};
    return {way};
}

std::vector<double> times_of(const Setup& setup, const Trial& trial) {
    std::vector<double> times;
    const bool thrown = setup.bench == Bench::lane || setup.bench == Bench::roll;
    const double begin = thrown ? 0.05 : 0; // a ball that is thrown is in the hand before
    for (int k = 0; k / setup.rate_hz < trial.lasts * setup.duration; ++k)
        if (k / setup.rate_hz >= begin)
            times.push_back(k / setup.rate_hz);
    return times;
}

Eigen::VectorXd readings_of(const Setup& setup, const Truth& truth) {
    std::vector<double> readings;
    std::vector<double> largest(channels_of(setup.bench).size(), 0); // one sensor sees all records
    for (std::size_t r = 0; truth.sensor.clip > 0 && r < setup.trials.size(); ++r) {
        const std::vector<Path>& paths = paths_in(setup, truth, r);
        for (std::size_t c = 0; c < paths.size(); ++c)
            largest[c] = std::max(largest[c], largest_of(paths[c], times_of(setup, setup.trials[r]).back()));
    }
    for (std::size_t r = 0; r < setup.trials.size(); ++r) {
        const std::size_t done = truth.swapped && (r == 0 || r == 2) ? 2 - r : r;
        const std::vector<Path>& paths = paths_in(setup, truth, done);
        for (std::size_t c = 0; c < paths.size(); ++c)
            for (const double y :
                 read(paths[c], truth.sensor, times_of(setup, setup.trials[r]), truth.offsets[r], largest[c]))
                readings.push_back(y / setup.sigma);
    }
    for (std::size_t r = 0; setup.clock && r < setup.trials.size(); ++r)
        for (const double time : times_of(setup, setup.trials[r]))
            readings.push_back((time - truth.offsets[r]) / (1 + truth.sensor.rate) / clock_sigma);
    return Eigen::Map<Eigen::VectorXd>(readings.data(), static_cast<Eigen::Index>(readings.size()));
}

namespace {

/// Calls with the first row and the length of every channel of every record, clocks aside.
template <class Each> void each_channel(const Setup& setup, Each each) {
    Eigen::Index first = 0;
    for (const Trial& trial : setup.trials)
        for (std::size_t c = 0; c < channels_of(setup.bench).size(); ++c) {
            const auto count = static_cast<Eigen::Index>(times_of(setup, trial).size());
            each(first, count);
            first += count;
        }
}

} // namespace

Eigen::VectorXd whitened(const Setup& setup, Eigen::VectorXd readings) {
    const double fresh = std::sqrt(1 - setup.memory * setup.memory);
    each_channel(setup, [&](Eigen::Index first, Eigen::Index count) {
        for (Eigen::Index k = first + count - 1; k > first; --k)
            readings[k] = (readings[k] - setup.memory * readings[k - 1]) / fresh;
    });
    return readings;
}

std::vector<bool> lone(const Setup& setup, const Eigen::VectorXd& differences) {
    constexpr double far = 4;
    constexpr Eigen::Index around = 3;
    std::vector<bool> all(static_cast<std::size_t>(differences.size()), false);
    each_channel(setup, [&](Eigen::Index first, Eigen::Index count) {
        for (Eigen::Index k = first; k < first + count; ++k) {
            const Eigen::Index from = std::max(first, k - around), to = std::min(first + count, k + around + 1);
            const auto others = (differences.segment(from, to - from).array().abs() > far).count();
            all[static_cast<std::size_t>(k)] = std::abs(differences[k]) > far && others <= 2; // itself and one more
        }
    });
    return all;
}

double share_of_one_record(const Setup& setup, const Eigen::VectorXd& differences) {
    std::vector<double> squares(setup.trials.size(), 0);
    const std::size_t channels = channels_of(setup.bench).size();
    std::size_t channel = 0;
    each_channel(setup, [&](Eigen::Index first, Eigen::Index count) {
        squares[channel++ / channels] += differences.segment(first, count).squaredNorm();
    });
    double all = 0;
    for (const double one : squares)
        all += one;
    return all > 0 ? *std::max_element(squares.begin(), squares.end()) / all : 0;
}

std::vector<Innocent> innocents_of(const Setup& setup) {
    std::vector<Innocent> innocents;
    const bool bounces_only = setup.bench == Bench::drop || setup.bench == Bench::plate;
    if (bounces_only || setup.bench == Bench::oblique)
        innocents.push_back({Innocent::law, [](Truth& t, double a) { t.ball.restitution += a; }, 0.05});
    if (!bounces_only && setup.bench != Bench::roll)
        innocents.push_back({Innocent::law,
                             [](Truth& t, double a) {
                                 t.lane.fast_friction *= 1 + a / t.lane.friction;
                                 t.lane.friction += a;
                             },
                             0.03});
    const bool thrown = setup.bench == Bench::lane || setup.bench == Bench::roll || setup.bench == Bench::oblique;
    for (std::size_t r = 0; r < setup.trials.size(); ++r) {
        innocents.push_back({Innocent::clock, [r](Truth& t, double a) { t.offsets[r] += a; },
                             setup.bench == Bench::spin ? 2e-3 : 5e-3});
        if (thrown)
            innocents.push_back({Innocent::throws, [r](Truth& t, double a) { t.speeds[r] += a; }, 0.03});
    }
    return innocents;
}

bool shows(const Effect& effect, Bench bench) {
    return (effect.shown & on(bench)) != 0;
}

namespace {

constexpr const char* words[] = {"drop", "lane", "slope", "roll", "oblique", "spin", "plate"};

} // namespace

std::string word_of(Bench bench) {
    return words[static_cast<int>(bench)];
}

Bench bench_of(const std::string& word) {
    const auto found = std::find(std::begin(words), std::end(words), word);
    return found == std::end(words) ? Bench::drop : static_cast<Bench>(found - std::begin(words));
}

const std::vector<Effect>& effects() {
    static const std::vector<Effect> every = all_effects();
    return every;
}

const Effect* find_effect(const std::string& id) {
    for (const Effect& effect : effects())
        if (effect.id == id)
            return &effect;
    return nullptr;
}

} // namespace blind
