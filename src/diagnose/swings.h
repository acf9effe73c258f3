#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace tumble::diagnose {

/// Probability that noise alone swings so much, below which mains show.
constexpr double shown_hum = 0.0027;

using Eigen::VectorXd;

/// Readings of one measure in one record, in rows as a Fit has them, and when each was read.
struct Course {
    std::string measure;
    Eigen::Index first = 0;
    std::vector<double> time; // s
};

/// Something that goes up and down at one frequency, with an amplitude and a phase of its own in every record.
struct Swing {
    std::string measure;
    double frequency = 0; // Hz
    double amplitude = 0; // standard errors of a reading, root mean square over the records
    double p = 1;         // that noise alone swings as much at any of the frequencies tried, of any measure
};

/// The strongest in a residual of scatter 1, between two periods in the shortest record and half its rate of readings.
/// Of every record least squares give chi-square of two dimensions, summed over records (the Lomb-Scargle periodogram,
/// Scargle 1982); p is that sum's tail times the frequencies tried, half a resolution apart (Bonferroni). Mains, 50 and
/// 60 Hz with the octave of each, folded at the rate of readings, are no swing of the experiment: where they show,
/// three resolutions to either side are left aside. Nothing where no record has 16 readings.
std::optional<Swing> strongest_swing(const VectorXd& residual, const std::vector<Course>& courses);

/// How much a residual swings at each of the frequencies that strongest_swing() tries, of one measure.
struct Spectrum {
    std::string measure;
    std::vector<double> frequency; // Hz, rising
    std::vector<double> amplitude; // standard errors of a reading, root mean square over the records
    double gate = 0;               // amplitude that noise alone reaches at any of them in 0.27 % of cases
};

/// One for each measure of which a record is long enough, mains not left aside.
std::vector<Spectrum> spectra_of(const VectorXd& residual, const std::vector<Course>& courses);

/// The strongest of mains only, each at its own frequency.
std::optional<Swing> mains_hum(const VectorXd& residual, const std::vector<Course>& courses);

} // namespace tumble::diagnose
