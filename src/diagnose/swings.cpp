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
    /// Mains show at this frequency once they are folded.
    [[nodiscard]] bool hums(double frequency) const {
        return std::any_of(std::begin(mains), std::end(mains), [&](double line) {
            const double folded = std::abs(line - rate * std::round(line / rate));
            return std::abs(frequency - folded) < beside_mains / shortest;
        });
    }
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

std::optional<Swing> strongest(const VectorXd& residual, const std::vector<Course>& courses, bool of_mains) {
    std::optional<Swing> found;
    const auto bands = bands_of(courses);
    for (const auto& [measure, band] : bands) {
        double most = 0, at = 0;
        int tried = 0;
        for (double f = band.from(); f < band.until(); f += band.step()) {
            if (band.hums(f) != of_mains)
                continue;
            ++tried;
            double sum = 0;
            for (const Course* course : band.courses)
                sum += taken(residual, *course, f);
            if (sum > most) {
                most = sum;
                at = f;
            }
        }
        if (tried == 0)
            continue;
        double readings = 0;
        for (const Course* course : band.courses)
            readings += static_cast<double>(course->time.size());
        const double dimensions = 2 * static_cast<double>(band.courses.size());
        const double p = std::min(1.0, static_cast<double>(bands.size()) * tried * chi_square_tail(most, dimensions));
        if (!found || p < found->p)
            found = Swing{measure, at, std::sqrt(2 * most / readings), p};
    }
    return found;
}

} // namespace

std::optional<Swing> strongest_swing(const VectorXd& residual, const std::vector<Course>& courses) {
    return strongest(residual, courses, false);
}

std::optional<Swing> mains_hum(const VectorXd& residual, const std::vector<Course>& courses) {
    return strongest(residual, courses, true);
}

} // namespace tumble::diagnose
