#include "excitation/spectrum.h"

#include "base/column.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace tumble::excitation {

namespace {

constexpr double beside = 25;      // resolutions, to either side, over which noise is averaged
constexpr double shadow = 0.6;     // resolutions about a line that the fit of that line has emptied
constexpr double independent = 20; // values that a median over the surroundings is worth

bool in_shadow(double frequency, double resolution, const std::vector<double>& lines) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](double line) { return std::abs(frequency - line) < shadow * resolution; });
}

std::vector<double> powers_beside(const Spectrum& spectrum, double frequency, const std::vector<double>& lines) {
    std::vector<double> powers;
    const double lo = std::max(frequency - beside * spectrum.resolution, spectrum.resolution);
    const double hi = frequency + beside * spectrum.resolution;
    for (auto k = static_cast<std::size_t>(lo / spectrum.step); k < spectrum.power.size(); ++k) {
        const double at = static_cast<double>(k) * spectrum.step;
        if (at > hi)
            break;
        if (!in_shadow(at, spectrum.resolution, lines))
            powers.push_back(spectrum.power[k]);
    }
    return powers;
}

} // namespace

double Spectrum::at(double frequency) const {
    const auto k = static_cast<std::size_t>(std::lround(frequency / step));
    return k < power.size() ? power[k] : 0.0;
}

Spectrum spectrum_of(const Eigen::VectorXd& samples, double spacing) {
    std::size_t size = 1;
    while (size < 4 * static_cast<std::size_t>(samples.size()))
        size *= 2;
    std::vector<double> padded(size, 0.0);
    std::copy(samples.begin(), samples.end(), padded.begin());
    std::vector<std::complex<double>> waves;
    Eigen::FFT<double> transform;
    transform.fwd(waves, padded);
    Spectrum spectrum;
    spectrum.step = 1 / (static_cast<double>(size) * spacing);
    spectrum.resolution = 1 / (static_cast<double>(samples.size()) * spacing);
    for (std::size_t k = 0; k <= size / 2; ++k)
        spectrum.power.push_back(std::norm(waves[k]) / static_cast<double>(samples.size()));
    return spectrum;
}

double noise_near(const Spectrum& spectrum, double frequency, const std::vector<double>& lines) {
    const std::vector<double> powers = powers_beside(spectrum, frequency, lines);
    double sum = 0;
    for (const double power : powers)
        sum += power;
    return powers.empty() ? 0.0 : sum / static_cast<double>(powers.size());
}

Peak highest_peak(const Spectrum& spectrum, double from, double to, const std::vector<double>& lines) {
    Peak highest;
    double noise = 0, noise_at = -1; // the surroundings change slowly: one median per few resolutions
    for (auto k = static_cast<std::size_t>(std::ceil(from / spectrum.step)); k < spectrum.power.size(); ++k) {
        const double at = static_cast<double>(k) * spectrum.step;
        if (at > to)
            break;
        if (in_shadow(at, spectrum.resolution, lines))
            continue;
        if (noise_at < 0 || at - noise_at > 4 * spectrum.resolution) {
            noise = median(powers_beside(spectrum, at, lines)) / std::numbers::ln2;
            noise_at = at;
        }
        if (noise > 0 && spectrum.power[k] / noise > highest.ratio)
            highest = {at, spectrum.power[k] / noise, spectrum.power[k]};
    }
    return highest;
}

double ratio_by_chance(const Spectrum& spectrum, double from, double to, double chance) {
    const double tries = std::max(1.0, 2 * (to - from) / spectrum.resolution); // the finer grid finds a little more
    return independent * (std::pow(tries / chance, 1 / independent) - 1);
}

} // namespace tumble::excitation
