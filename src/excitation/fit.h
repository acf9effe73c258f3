#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <vector>

/// Waves through measured signals by least squares: amplitudes and phases are linear, frequencies and decays are not.
namespace tumble::excitation {

struct Signal {
    std::vector<double> time, value; // s; m/s2
    double origin = 0;               // s, where phases and decays count from
};

/// exp(-d t) (C cos(2 pi f t) + S sin(2 pi f t)) with f = factor * parameters[frequency], and d = parameters[decay] or
/// none. Waves that share a parameter are tied: orders of one machine.
struct Wave {
    int frequency = 0; // index into the parameters, Hz
    double factor = 1;
    int decay = -1; // index into the parameters, 1/s; -1: none
};

constexpr int drift_terms = 3; // offset, slope and bend of every signal, before the waves' coefficients

struct FittedSignal {
    Eigen::VectorXd coefficients; // drift, then C and S of every wave
    Eigen::MatrixXd covariance;   // of them, with the parameters known and white noise
    Eigen::MatrixXd shift;        // how they follow the parameters along the best fit
    Eigen::VectorXd rest;         // what is left of the signal
    double noise = 0;             // standard deviation of it

    [[nodiscard]] double cosine(std::size_t wave) const { return coefficients[index(wave)]; }
    [[nodiscard]] double sine(std::size_t wave) const { return coefficients[index(wave) + 1]; }
    /// m/s2
    [[nodiscard]] double amplitude(std::size_t wave) const { return std::hypot(cosine(wave), sine(wave)); }
    static Eigen::Index index(std::size_t wave) { return drift_terms + 2 * static_cast<Eigen::Index>(wave); }
};

struct Fit {
    std::vector<double> parameters;
    Eigen::MatrixXd covariance; // of the parameters, white noise
    std::vector<FittedSignal> signals;
    bool settled = false; // the last step was small beside the standard errors

    [[nodiscard]] double frequency(const Wave& wave) const {
        return wave.factor * parameters[static_cast<std::size_t>(wave.frequency)];
    }
};

/// Gauss-Newton on the parameters with the coefficients projected out (Golub and Pereyra 1973, in Kaufman's form), from
/// `start` on, at most `rounds` rounds. Each signal has its own coefficients and its own noise, found from what it
/// leaves; the parameters are common.
Fit fit_waves(const std::vector<Signal>& signals, const std::vector<Wave>& waves, std::vector<double> start,
              int rounds);

} // namespace tumble::excitation
