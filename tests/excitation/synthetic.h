#pragma once

#include "base/rng.h"
#include "excitation/record.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <string>
#include <vector>

/// Records whose truth is known, written down here and not by the code under test.
namespace tumble::excitation::testing {

constexpr double pi = std::numbers::pi;

/// Displacement of a wall along one axis: amplitude sin(2 pi f t + phase), as a scene's harmonic.
struct Tone {
    int axis = 0;
    double frequency = 0, amplitude = 0, phase = 0; // Hz, m, rad

    /// m/s2, the second derivative.
    [[nodiscard]] double acceleration(double t) const {
        return -amplitude * std::pow(2 * pi * frequency, 2) * std::sin(2 * pi * frequency * t + phase);
    }
};

/// How it was recorded.
struct Recorder {
    double rate = 1000, duration = 2; // Hz, s
    double noise = 0;                 // m/s2, standard deviation
    double jitter = 0;                // of a step, uniform, either way
    double offset[3] = {0, 0, 0};     // m/s2
    double drift = 0;                 // m/s2 from the first sample to the last
    std::uint64_t seed = 1;
};

/// Standard normal number (Box and Muller 1958).
inline double normal(Rng& rng) {
    return std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(2 * pi * rng.uniform());
}

/// Time 0 is the first sample.
inline Record recorded(const std::vector<Tone>& tones, const Recorder& how, int channels = 3) {
    Rng rng(how.seed);
    Record record;
    record.file = "made.csv";
    const auto samples = static_cast<int>(how.rate * how.duration);
    for (int k = 0; k < samples; ++k)
        record.time.push_back((k + (k > 0 ? how.jitter * rng.uniform(-1, 1) : 0)) / how.rate);
    for (int axis = 0; axis < channels; ++axis) {
        Channel channel{std::string("a") + "xyz" [axis], axis, 0, {}};
        for (const double t : record.time) {
            double a = how.offset[axis] + how.drift * t / how.duration + how.noise * normal(rng);
            for (const Tone& tone : tones)
                if (tone.axis == axis)
                    a += tone.acceleration(t);
            channel.values.push_back(a);
        }
        record.channels.push_back(std::move(channel));
    }
    return record;
}

/// As a CSV file in SI units, every digit kept.
std::string csv_of(const Record& record);

/// Smallest angle between two, rad.
inline double between(double a, double b) {
    return std::abs(std::remainder(a - b, 2 * pi));
}

} // namespace tumble::excitation::testing
