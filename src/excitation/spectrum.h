#pragma once

#include <Eigen/Core>
#include <vector>

/// Where to look for lines, and how much noise there is beside them. Frequencies that are reported never come from
/// here: they are fitted.
namespace tumble::excitation {

/// |sum y exp(-2 pi i f t)|^2 / N at the multiples of `step`: of white noise its variance, of a line N a^2 / 4.
struct Spectrum {
    double step = 0;       // Hz
    double resolution = 0; // Hz, 1 / duration
    std::vector<double> power;

    [[nodiscard]] double at(double frequency) const;
};

/// Of samples `spacing` seconds apart, on a grid four times finer than the resolution or more.
Spectrum spectrum_of(const Eigen::VectorXd& samples, double spacing);

/// Variance that white noise of the density near `frequency` would have: mean over 25 resolutions to either side
/// without those next to `lines` (Hz), where a fit has taken the noise away.
double noise_near(const Spectrum& spectrum, double frequency, const std::vector<double>& lines);

/// Between two frequencies the highest power over the running middle of its surroundings, lines left out.
struct Peak {
    double frequency = 0; // Hz
    double ratio = 0;     // power over the noise around it
    double power = 0;
};
Peak highest_peak(const Spectrum& spectrum, double from, double to, const std::vector<double>& lines);

/// The ratio that noise alone passes with probability `chance` anywhere between two frequencies. The noise around a
/// peak is itself estimated from few values, which is allowed for.
double ratio_by_chance(const Spectrum& spectrum, double from, double to, double chance);

} // namespace tumble::excitation
