#include "excitation/lines.h"

#include "base/text.h"
#include "excitation/fit.h"
#include "excitation/samples.h"
#include "excitation/spectrum.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::excitation {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double chance = 1e-3; // of taking noise for a line, anywhere
constexpr int most_lines = 48;
constexpr double motor_range = 0.08; // of the nominal speed
constexpr double fewest_periods = 3;
constexpr double smallest_line = 1e-6;    // of the strongest: below, sums of rounded numbers make lines
constexpr double near = 0.5;              // resolutions: a peak this near may be that line
constexpr double sure = 4.5;              // standard errors that a line is off before it is another
constexpr double sure_resolutions = 0.05; // and so many resolutions: speeds wander
constexpr double mains_wander = 0.2;      // Hz, of the fundamental of the grid

double distance(double a, double b) {
    return std::abs(a - b);
}

class Finder {
public:
    Finder(const Record& record, const Settings& settings)
        : record_(record), settings_(settings), samples_(samples_of(record, settings.up_to)) {
        found_.reference = record.time.front();
        found_.resolution = 1 / record.duration();
        top_ = std::min(settings.up_to, 0.45 / samples_.spacing);
    }

    Result<Excitation> find() {
        if (const auto problem = find_fundamental())
            return *problem;
        while (waves_.size() < most_lines && add_line()) {
        }
        free_what_is_no_order();
        fit_ = fit_waves(samples_.signals, waves_, fit_.parameters, 20);
        if (!fit_.settled)
            found_.warnings.push_back({.file = record_.file,
                                       .what = "the frequencies did not settle to the last digit",
                                       .fix = "a speed that wanders does this; record a steady stretch"});
        report();
        return std::move(found_);
    }

private:
    [[nodiscard]] double half_order() const { return 0.5 * fit_.parameters[0]; }
    [[nodiscard]] std::vector<double> frequencies() const {
        std::vector<double> all;
        for (const Wave& wave : waves_)
            all.push_back(fit_.frequency(wave));
        return all;
    }
    [[nodiscard]] std::vector<Spectrum> rests() const {
        std::vector<Spectrum> all;
        for (const FittedSignal& signal : fit_.signals)
            all.push_back(spectrum_of(signal.rest, samples_.spacing));
        return all;
    }

    /// The strongest line of all channels together, then fitted.
    std::optional<Problem> find_fundamental() {
        double from = fewest_periods * found_.resolution, to = top_;
        if (settings_.motor > 0) {
            from = std::max(from, (1 - motor_range) * settings_.motor);
            to = std::min(to, (1 + motor_range) * settings_.motor);
        }
        if (from >= to)
            return Problem{.file = record_.file,
                           .what = fmt::format("{} hold fewer than {:.0f} periods of the lowest line looked for",
                                               format_si(record_.duration(), "s", 3), fewest_periods),
                           .fix = "record longer, or give a higher --motor_rpm or --up_to_Hz"};
        fit_ = fit_waves(samples_.signals, {}, {}, 0);
        Spectrum sum;
        double best = 0;
        for (const Spectrum& spectrum : rests()) {
            best = std::max(best, highest_peak(spectrum, from, to, {}).ratio);
            if (sum.power.empty())
                sum = spectrum;
            else
                for (std::size_t k = 0; k < sum.power.size(); ++k)
                    sum.power[k] += spectrum.power[k];
        }
        if (best < ratio_by_chance(sum, from, to, chance))
            return Problem{.file = record_.file,
                           .what = "no line stands out of the noise",
                           .fix =
                               "record while the machine runs, with the sensor fixed to the wall; knocks on a machine "
                               "at rest take --hammer"};
        const auto first = static_cast<std::size_t>(std::ceil(from / sum.step));
        const auto last = std::min(sum.power.size(), static_cast<std::size_t>(to / sum.step) + 1);
        const auto top = std::max_element(sum.power.begin() + static_cast<std::ptrdiff_t>(first),
                                          sum.power.begin() + static_cast<std::ptrdiff_t>(last));
        const double guess = static_cast<double>(top - sum.power.begin()) * sum.step;
        waves_ = {{0, 1.0}};
        fit_ = fit_waves(samples_.signals, waves_, {guess}, 20);
        return std::nullopt;
    }

    /// Adds the line that stands highest out of what is left; false when none does.
    bool add_line() {
        const std::vector<double> lines = frequencies();
        const double from = 2 * found_.resolution;
        Peak highest;
        double needed = 0, strongest = 0;
        for (const FittedSignal& signal : fit_.signals)
            strongest = std::max(strongest, signal.amplitude(0));
        for (const Spectrum& spectrum : rests()) {
            const Peak peak = highest_peak(spectrum, from, top_, lines);
            if (peak.ratio > highest.ratio)
                highest = peak;
            needed = ratio_by_chance(spectrum, from, top_, chance / static_cast<double>(fit_.signals.size()));
        }
        const double amplitude = 2 * std::sqrt(highest.power / static_cast<double>(samples_.signals[0].time.size()));
        if (highest.ratio < needed || amplitude < smallest_line * strongest)
            return false;
        const double halves = std::max(1.0, std::round(highest.frequency / half_order()));
        const double multiple = std::max(1.0, std::round(highest.frequency / settings_.mains));
        const double from_order = distance(highest.frequency, halves * half_order());
        const double from_mains = distance(highest.frequency, multiple * settings_.mains);
        std::vector<double> start = fit_.parameters;
        if (from_order < near * found_.resolution && from_order <= from_mains && !taken(halves * half_order())) {
            waves_.push_back({0, halves / 2});
        } else {
            const bool mains = from_mains < near * found_.resolution && !taken(multiple * settings_.mains);
            start.push_back(mains ? multiple * settings_.mains : highest.frequency);
            waves_.push_back({static_cast<int>(start.size()) - 1, 1.0});
        }
        fit_ = fit_waves(samples_.signals, waves_, std::move(start), 4);
        return true;
    }

    [[nodiscard]] bool taken(double frequency) const {
        const std::vector<double> lines = frequencies();
        return std::any_of(lines.begin(), lines.end(),
                           [&](double line) { return distance(line, frequency) < near * found_.resolution; });
    }

    /// Every order gets a frequency of its own for once; one that then moves away surely was no order.
    void free_what_is_no_order() {
        std::vector<Wave> loose = waves_;
        std::vector<double> start = fit_.parameters;
        for (Wave& wave : loose)
            if (wave.frequency == 0 && wave.factor != 1.0) {
                start.push_back(fit_.frequency(wave));
                wave = {static_cast<int>(start.size()) - 1, 1.0};
            }
        const Fit fit = fit_waves(samples_.signals, loose, start, 6);
        std::vector<double> kept = fit_.parameters;
        for (std::size_t k = 0; k < waves_.size(); ++k) {
            if (waves_[k].frequency != 0 || waves_[k].factor == 1.0)
                continue;
            const double off = distance(fit.frequency(loose[k]), fit_.frequency(waves_[k]));
            if (off > sure * frequency_error(fit, loose, k) && off > sure_resolutions * found_.resolution &&
                off < found_.resolution) {
                kept.push_back(fit.frequency(loose[k]));
                waves_[k] = {static_cast<int>(kept.size()) - 1, 1.0};
            }
        }
        fit_.parameters = std::move(kept);
    }

    /// How much noisier than white the surroundings of each wave are on each signal: variance over the fit's own.
    [[nodiscard]] std::vector<std::vector<double>> colour_of(const Fit& fit, const std::vector<Wave>& waves) const {
        std::vector<double> lines;
        for (const Wave& wave : waves)
            lines.push_back(fit.frequency(wave));
        std::vector<std::vector<double>> colour;
        for (const FittedSignal& signal : fit.signals) {
            const Spectrum rest = spectrum_of(signal.rest, samples_.spacing);
            colour.emplace_back();
            for (const double line : lines) {
                const double near_by = noise_near(rest, line, lines);
                colour.back().push_back(near_by > 0 ? near_by / (signal.noise * signal.noise) : 1.0);
            }
        }
        return colour;
    }

    /// Variance of a parameter over what white noise gives it: its waves' colours, weighted by what each tells of it.
    static double colour_of_parameter(const Fit& fit, const std::vector<Wave>& waves, int parameter,
                                      const std::vector<std::vector<double>>& colour) {
        double told = 0, coloured = 0;
        for (std::size_t s = 0; s < fit.signals.size(); ++s)
            for (std::size_t k = 0; k < waves.size(); ++k) {
                if (waves[k].frequency != parameter)
                    continue;
                const double tells = std::pow(waves[k].factor * fit.signals[s].amplitude(k) / fit.signals[s].noise, 2);
                told += tells;
                coloured += tells * colour[s][k];
            }
        return told > 0 ? coloured / told : 1.0;
    }

    [[nodiscard]] double frequency_error(const Fit& fit, const std::vector<Wave>& waves, std::size_t k) const {
        const auto p = static_cast<Eigen::Index>(waves[k].frequency);
        const double colour = colour_of_parameter(fit, waves, waves[k].frequency, colour_of(fit, waves));
        return waves[k].factor * std::sqrt(std::max(0.0, fit.covariance(p, p)) * colour);
    }

    void report() {
        const auto colour = colour_of(fit_, waves_);
        Eigen::VectorXd swell(static_cast<Eigen::Index>(fit_.parameters.size()));
        for (Eigen::Index p = 0; p < swell.size(); ++p)
            swell[p] = std::sqrt(colour_of_parameter(fit_, waves_, static_cast<int>(p), colour));
        const Eigen::MatrixXd covariance = swell.asDiagonal() * fit_.covariance * swell.asDiagonal();
        found_.fundamental = fit_.parameters[0];
        found_.fundamental_se = std::sqrt(std::max(0.0, covariance(0, 0)));
        double all = 0, left = 0;
        for (std::size_t s = 0; s < fit_.signals.size(); ++s) {
            found_.offset.push_back(fit_.signals[s].coefficients[0]);
            found_.noise.push_back(fit_.signals[s].noise);
            const Eigen::Map<const Eigen::VectorXd> y(samples_.signals[s].value.data(),
                                                      static_cast<Eigen::Index>(samples_.signals[s].value.size()));
            all += (y.array() - y.mean()).square().sum();
            left += fit_.signals[s].rest.squaredNorm();
        }
        found_.explained = all > 0 ? 1 - left / all : 0;
        for (std::size_t k = 0; k < waves_.size(); ++k)
            add_to_report(k, covariance, colour);
        std::sort(found_.lines.begin(), found_.lines.end(),
                  [](const Line& a, const Line& b) { return a.frequency < b.frequency; });
    }

    void add_to_report(std::size_t k, const Eigen::MatrixXd& covariance,
                       const std::vector<std::vector<double>>& colour) {
        const auto p = static_cast<Eigen::Index>(waves_[k].frequency);
        Line line;
        line.frequency = fit_.frequency(waves_[k]);
        line.frequency_se = waves_[k].factor * std::sqrt(std::max(0.0, covariance(p, p)));
        bool seen = false;
        for (std::size_t s = 0; s < fit_.signals.size(); ++s) {
            line.on.push_back(component(k, s, covariance, colour[s][k]));
            seen |= line.on.back().seen;
        }
        if (!seen && k > 0)
            return;
        name(line, p == 0);
        found_.lines.push_back(std::move(line));
    }

    /// Amplitude and phase with their errors, those of the frequency included.
    [[nodiscard]] Component component(std::size_t k, std::size_t s, const Eigen::MatrixXd& covariance,
                                      double colour) const {
        const FittedSignal& signal = fit_.signals[s];
        const Eigen::Index i = FittedSignal::index(k);
        const double c = signal.cosine(k), e = signal.sine(k), a = std::max(std::hypot(c, e), 1e-100);
        const Eigen::Matrix2d own = colour * signal.covariance.block<2, 2>(i, i);
        const Eigen::MatrixXd shift = signal.shift.middleRows<2>(i);
        const Eigen::Matrix2d both = own + shift * covariance * shift.transpose();
        const Eigen::Vector2d along(c / a, e / a), across(e / (a * a), -c / (a * a)); // of amplitude, of phase
        const auto p = static_cast<Eigen::Index>(waves_[k].frequency);
        const double back = turn * waves_[k].factor * (found_.reference - samples_.signals[s].origin);
        const double with_frequency = across.dot(shift * covariance.col(p));

        const double gain = samples_.gain(fit_.frequency(waves_[k]));
        Component component;
        component.acceleration = a / gain;
        component.acceleration_se = std::sqrt(along.dot(both * along)) / gain;
        component.phase = std::remainder(std::atan2(c, e) + turn * fit_.frequency(waves_[k]) *
                                                                (found_.reference - samples_.signals[s].origin),
                                         turn);
        component.phase_se = std::sqrt(
            std::max(0.0, across.dot(both * across) + back * back * covariance(p, p) + 2 * back * with_frequency));
        component.beside_se = std::sqrt(across.dot(own * across));
        const double tries = static_cast<double>(waves_.size() * fit_.signals.size());
        component.seen = a * a > own.trace() * std::log(tries / chance);
        return component;
    }

    void name(Line& line, bool tied) const {
        const double order = std::round(line.frequency / half_order());
        const double multiple = std::round(line.frequency / settings_.mains);
        const double slack = std::max(sure * line.frequency_se, sure_resolutions * found_.resolution);
        const bool grid = multiple >= 1 && distance(line.frequency, multiple * settings_.mains) <
                                               std::max(slack, mains_wander * multiple);
        const double apart = distance(order * half_order(), multiple * settings_.mains);
        line.halves = tied ? static_cast<int>(order) : 0;
        if (tied && multiple >= 1 && apart < near * found_.resolution) {
            line.kind = Kind::unclear;
            line.multiple = static_cast<int>(multiple);
        } else if (tied) {
            line.kind = Kind::order;
        } else if (grid) {
            line.kind = Kind::mains;
            line.multiple = static_cast<int>(multiple);
        }
    }

    const Record& record_;
    const Settings& settings_;
    Samples samples_;
    double top_ = 0; // Hz
    std::vector<Wave> waves_;
    Fit fit_;
    Excitation found_;
};

} // namespace

const Line& Excitation::first_order() const {
    return *std::find_if(lines.begin(), lines.end(), [](const Line& line) { return line.halves == 2; });
}

Result<Excitation> find_lines(const Record& record, const Settings& settings) {
    return Finder(record, settings).find();
}

std::optional<Slip> slip_of(double fundamental, double mains) {
    for (int pairs = 1; pairs <= 12; ++pairs)
        if (const double field = mains / pairs; fundamental <= field && fundamental > (1 - motor_range) * field)
            return Slip{pairs, field};
    return std::nullopt;
}

} // namespace tumble::excitation
