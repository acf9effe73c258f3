#include "excitation/knock.h"

#include "base/column.h"
#include "excitation/fit.h"
#include "excitation/samples.h"
#include "excitation/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::excitation {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double look = 0.01;         // s, over which the largest motion is compared with that before
constexpr double rise = 3;            // times what was before: a knock, not ringing
constexpr double share = 0.2;         // of the largest knock, at least
constexpr double settle = 0.01;       // s after the peak: the hammer's tip has left by then
constexpr double shortest_ring = 0.1; // s between knocks that can be used
constexpr double first_damping = 0.02;
constexpr double chance = 1e-3;
constexpr std::size_t most_modes = 8;
constexpr double widest = 0.3; // damping above this is no ringing

/// How far all channels are from their middle together.
std::vector<double> excursion_of(const Record& record) {
    std::vector<double> excursion(record.time.size(), 0.0);
    for (const Channel& channel : record.channels) {
        const double middle = median(channel.values);
        for (std::size_t k = 0; k < excursion.size(); ++k)
            excursion[k] = std::max(excursion[k], std::abs(channel.values[k] - middle));
    }
    return excursion;
}

std::vector<std::size_t> knocks_in(const Record& record) {
    const std::vector<double> excursion = excursion_of(record);
    const double quiet = median(excursion), largest = *std::max_element(excursion.begin(), excursion.end());
    const auto width = std::max<std::size_t>(2, static_cast<std::size_t>(look / record.step()));
    std::vector<std::size_t> knocks;
    for (std::size_t k = width; k + width < excursion.size(); ++k) {
        const auto at = excursion.begin() + static_cast<std::ptrdiff_t>(k);
        const auto reach = static_cast<std::ptrdiff_t>(width);
        const auto peak = std::max_element(at, at + reach);
        const double before = *std::max_element(at - reach, at);
        if (*peak < share * largest || *peak < rise * before || *peak < rise * quiet)
            continue;
        knocks.push_back(static_cast<std::size_t>(peak - excursion.begin()));
        k = knocks.back() + width;
    }
    return knocks;
}

/// The stretches after the knocks, each channel of each a signal of its own.
std::vector<Signal> rings_after(const std::vector<std::size_t>& knocks, const Record& record, const Samples& samples) {
    std::vector<Signal> rings;
    for (std::size_t k = 0; k < knocks.size(); ++k) {
        const double from = record.time[knocks[k]] + settle;
        const double to = k + 1 < knocks.size() ? record.time[knocks[k + 1]] - settle : record.time.back();
        if (to - from < shortest_ring)
            continue;
        for (const Signal& signal : samples.signals) {
            Signal ring{{}, {}, from};
            for (std::size_t j = 0; j < signal.time.size(); ++j)
                if (signal.time[j] >= from && signal.time[j] <= to) {
                    ring.time.push_back(signal.time[j]);
                    ring.value.push_back(signal.value[j]);
                }
            rings.push_back(std::move(ring));
        }
    }
    return rings;
}

class ModeFinder {
public:
    ModeFinder(std::vector<Signal> rings, const Samples& samples, double top)
        : rings_(std::move(rings)), samples_(samples), top_(top), fit_(fit_waves(rings_, {}, {}, 0)) {}

    Fit find() {
        while (waves_.size() < most_modes && add_mode()) {
        }
        fit_ = fit_waves(rings_, waves_, fit_.parameters, 40);
        return fit_;
    }
    [[nodiscard]] const std::vector<Wave>& waves() const { return waves_; }

private:
    bool add_mode() {
        std::vector<double> lines;
        for (const Wave& wave : waves_)
            lines.push_back(fit_.frequency(wave));
        Peak highest;
        double needed = 0;
        for (const FittedSignal& signal : fit_.signals) {
            const Spectrum rest = spectrum_of(signal.rest, samples_.spacing);
            const Peak peak = highest_peak(rest, 2 * rest.resolution, top_, lines);
            if (peak.ratio > highest.ratio)
                highest = peak;
            needed = std::max(needed, ratio_by_chance(rest, 2 * rest.resolution, top_,
                                                      chance / static_cast<double>(fit_.signals.size())));
        }
        if (highest.ratio < needed)
            return false;
        std::vector<Wave> more = waves_;
        std::vector<double> start = fit_.parameters;
        const int next = static_cast<int>(start.size());
        more.push_back({next, 1.0, next + 1});
        start.push_back(highest.frequency);
        start.push_back(first_damping * turn * highest.frequency);
        const Fit fit = fit_waves(rings_, more, start, 20);
        const double decay = fit.parameters.back();
        if (!(decay > 0) || decay > widest * turn * fit.frequency(more.back()))
            return false; // what is left does not ring
        waves_ = std::move(more);
        fit_ = fit;
        return true;
    }

    std::vector<Signal> rings_;
    const Samples& samples_;
    double top_ = 0; // Hz
    std::vector<Wave> waves_;
    Fit fit_;
};

Mode mode_of(const Fit& fit, const Wave& wave, std::size_t index, const Samples& samples, std::size_t channels) {
    const auto f = static_cast<Eigen::Index>(wave.frequency), d = static_cast<Eigen::Index>(wave.decay);
    const double damped = turn * fit.parameters[static_cast<std::size_t>(f)];
    const double decay = fit.parameters[static_cast<std::size_t>(d)], natural = std::hypot(damped, decay);
    // The damped frequency and the decay are all but independent, and damping is small.
    const double se_f = std::sqrt(std::max(0.0, fit.covariance(f, f)));
    const double se_d = std::sqrt(std::max(0.0, fit.covariance(d, d)));
    Mode mode{natural / turn, std::hypot(damped / natural * se_f, decay / natural * se_d / turn), decay / natural,
              damped / natural * std::hypot(se_d / natural, decay / natural * turn * se_f / natural),
              std::vector<double>(channels, 0.0)};
    for (std::size_t s = 0; s < fit.signals.size(); ++s) {
        double& largest = mode.largest[s % channels];
        largest =
            std::max(largest, fit.signals[s].amplitude(index) * std::exp(decay * settle) / samples.gain(damped / turn));
    }
    return mode;
}

} // namespace

Result<Ringing> find_modes(const Record& record, const Settings& settings) {
    const Samples samples = samples_of(record, settings.up_to);
    const std::vector<std::size_t> knocks = knocks_in(record);
    const std::vector<Signal> rings = rings_after(knocks, record, samples);
    if (rings.empty())
        return Problem{.file = record.file,
                       .what = "no knock stands out of the record with a quiet stretch before it and 0.1 s after it",
                       .fix = "begin the record before the knock, and wait between knocks until the machine is quiet"};
    ModeFinder finder(rings, samples, std::min(settings.up_to, 0.45 / samples.spacing));
    const Fit fit = finder.find();
    if (finder.waves().empty())
        return Problem{.file = record.file,
                       .what = "nothing rings after the knocks",
                       .fix = "knock harder, or with a harder tip; fix the sensor with a stud"};
    Ringing ringing;
    for (const std::size_t knock : knocks)
        ringing.knocks.push_back(record.time[knock]);
    for (std::size_t k = 0; k < finder.waves().size(); ++k)
        ringing.modes.push_back(mode_of(fit, finder.waves()[k], k, samples, record.channels.size()));
    std::sort(ringing.modes.begin(), ringing.modes.end(),
              [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
    if (!fit.settled)
        ringing.warnings.push_back(
            {.file = record.file,
             .what = "frequencies and decays did not settle to the last digit",
             .fix = "modes that lie close together do this; knock where one of them is at rest"});
    return ringing;
}

} // namespace tumble::excitation
