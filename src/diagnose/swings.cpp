#include "diagnose/swings.h"

#include "base/column.h"
#include "base/distributions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace tumble::diagnose {

namespace {

constexpr std::size_t fewest = 16; // readings of a record
constexpr double least_periods = 2;
constexpr double beside_mains = 3; // resolutions: farther off a line leaks less than a hundredth of its power
constexpr double mains[] = {50, 60, 100, 120}; // Hz

/// The records of one measure, and the frequencies that all of them resolve.
struct Band {
    std::vector<const Course*> courses;
    double length = 0;       // s, of the longest record
    double shortest = 1e300; // s
    double rate = 1e300;     // Hz, of readings, the lowest
    [[nodiscard]] double step() const { return 0.5 / length; }
    [[nodiscard]] double from() const { return least_periods / shortest; }
    /// At half the rate itself a sine cannot be told from nothing.
    [[nodiscard]] double until() const { return 0.5 * rate - 1 / shortest; }
    [[nodiscard]] double dimensions() const { return 2 * static_cast<double>(courses.size()); }
    /// Of a swing that takes so much of chi-square, standard errors of a reading.
    [[nodiscard]] double amplitude(double taken) const {
        double readings = 0;
        for (const Course* course : courses)
            readings += static_cast<double>(course->time.size());
        return std::sqrt(2 * taken / readings);
    }
    /// Where a line shows that is folded at the rate of readings.
    [[nodiscard]] double folded(double line) const { return std::abs(line - rate * std::round(line / rate)); }
};

std::map<std::string, Band> bands_of(const std::vector<Course>& courses) {
    std::map<std::string, Band> bands;
    for (const Course& course : courses) {
        if (course.time.size() < fewest)
            continue;
        Band& band = bands[course.measure];
        const double length = course.time.back() - course.time.front();
        band.courses.push_back(&course);
        band.length = std::max(band.length, length);
        band.shortest = std::min(band.shortest, length);
        std::vector<double> steps;
        for (std::size_t k = 1; k < course.time.size(); ++k)
            steps.push_back(course.time[k] - course.time[k - 1]);
        band.rate = std::min(band.rate, 1 / median(std::move(steps))); // frames may be lost
    }
    return bands;
}

/// What a sine of this frequency takes of chi-square in one record.
double taken(const VectorXd& residual, const Course& course, double frequency) {
    double cc = 0, cs = 0, ss = 0, cr = 0, sr = 0;
    for (std::size_t k = 0; k < course.time.size(); ++k) {
        const double angle = 2 * std::numbers::pi * frequency * course.time[k];
        const double c = std::cos(angle), s = std::sin(angle);
        const double r = residual[course.first + static_cast<Eigen::Index>(k)];
        cc += c * c;
        cs += c * s;
        ss += s * s;
        cr += c * r;
        sr += s * r;
    }
    const double determinant = cc * ss - cs * cs;
    return (ss * cr * cr - 2 * cs * cr * sr + cc * sr * sr) / determinant;
}

double taken_by(const VectorXd& residual, const Band& band, double frequency) {
    double sum = 0;
    for (const Course* course : band.courses)
        sum += taken(residual, *course, frequency);
    return sum;
}

/// The strongest of these frequencies; `tests`: how many of its kind are made.
std::optional<Swing> strongest_of(const VectorXd& residual, const std::string& measure, const Band& band,
                                  const std::vector<double>& frequencies, std::size_t tests) {
    if (frequencies.empty())
        return std::nullopt;
    double most = 0, at = 0;
    for (const double f : frequencies)
        if (const double sum = taken_by(residual, band, f); sum > most) {
            most = sum;
            at = f;
        }
    const auto tried = static_cast<double>(tests * frequencies.size());
    return Swing{measure, at, band.amplitude(most), std::min(1.0, tried * chi_square_tail(most, band.dimensions()))};
}

/// The chi-square that has this tail.
double chi_square_quantile(double tail, double dimensions) {
    double low = 0, high = dimensions + 10;
    while (chi_square_tail(high, dimensions) > tail)
        high *= 2;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (chi_square_tail(middle, dimensions) > tail ? low : high) = middle;
    }
    return high;
}

/// Where mains would show, as far as they can.
std::vector<double> mains_in(const Band& band) {
    std::vector<double> lines;
    for (const double line : mains)
        if (const double f = band.folded(line); f > band.from() && f < band.until())
            lines.push_back(f);
    return lines;
}

void keep_stronger(std::optional<Swing>& found, const std::optional<Swing>& other) {
    if (other && (!found || other->p < found->p))
        found = other;
}

} // namespace

std::optional<Swing> strongest_swing(const VectorXd& residual, const std::vector<Course>& courses) {
    std::optional<Swing> found;
    const auto bands = bands_of(courses);
    for (const auto& [measure, band] : bands) {
        std::vector<double> hums;
        for (const double line : mains_in(band))
            if (strongest_of(residual, measure, band, {line}, std::size(mains))->p < shown_hum)
                hums.push_back(line);
        std::vector<double> frequencies;
        for (double f = band.from(); f < band.until(); f += band.step())
            if (std::none_of(hums.begin(), hums.end(), [&, width = beside_mains / band.shortest](double hum) {
                    return std::abs(f - hum) < width;
                }))
                frequencies.push_back(f);
        keep_stronger(found, strongest_of(residual, measure, band, frequencies, bands.size()));
    }
    return found;
}

std::vector<Spectrum> spectra_of(const VectorXd& residual, const std::vector<Course>& courses) {
    std::vector<Spectrum> spectra;
    for (const auto& [measure, band] : bands_of(courses)) {
        Spectrum spectrum{.measure = measure, .frequency = {}, .amplitude = {}, .gate = 0};
        for (double f = band.from(); f < band.until(); f += band.step()) {
            spectrum.frequency.push_back(f);
            spectrum.amplitude.push_back(band.amplitude(taken_by(residual, band, f)));
        }
        if (spectrum.frequency.empty())
            continue;
        const double tail = shown_hum / static_cast<double>(spectrum.frequency.size());
        spectrum.gate = band.amplitude(chi_square_quantile(tail, band.dimensions()));
        spectra.push_back(std::move(spectrum));
    }
    return spectra;
}

std::optional<Swing> mains_hum(const VectorXd& residual, const std::vector<Course>& courses) {
    std::optional<Swing> found;
    const auto bands = bands_of(courses);
    for (const auto& [measure, band] : bands)
        keep_stronger(found, strongest_of(residual, measure, band, mains_in(band), bands.size()));
    return found;
}

} // namespace tumble::diagnose
