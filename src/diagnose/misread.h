#pragma once

#include "diagnose/fit.h"
#include "diagnose/measurement.h"
#include "diagnose/signal.h"

#include <Eigen/Core>
#include <limits>
#include <optional>

namespace tumble::diagnose {

/// A slip of whoever wrote the files, and the records that would agree without it.
struct Misread {
    std::vector<std::size_t> records;
    Problem problem;
    double times = std::numeric_limits<double>::infinity(); // as well, as they then agree
    double left = 0;                                        // mean square of what they then miss, in standard errors
};

/// What was simulated of a record, and how well its readings are known.
struct Simulated {
    std::vector<Signal> truth; // a channel each
    std::vector<double> sigma; // SI, a channel each
};

/// All that follows, as the scene is written; sensors that held on to a reading are warnings, whatever a fit makes of
/// them. `predicted`: of every reading of every record.
std::vector<Misread> misread_in(Model& model, const Noise& noise, const VectorXd& predicted, Problems& warnings);

/// Those of which the fitted baseline, too, misses every record by five scatters, root mean square, and by twice what
/// is left without the slip: nuisances explain the others, or most of them. Those that mend most come first.
Problems standing(const std::vector<Misread>& misread, const Fit& baseline, const Model& model);

/// Records over time that miss what was simulated by ten times their scatter and agree five times as well, or better,
/// if they are read otherwise than their file says: their time begins later, jumps, or runs faster, a column is turned,
/// of another scale or another zero; or records were exchanged (three times as well). One sentence for each record, of
/// what agrees best; where one rate of time mends all of them, that alone. Where nothing mends a record, another place
/// than the scene's at which it begins, while most do not. A zero that all records have is an instrument's.
std::vector<Misread> record_slips(const std::vector<Record>& records, const std::vector<Simulated>& simulated);

/// Series over time with the same sets and sensors whose readings differ by far more than they scatter.
std::vector<Misread> forgotten_sets(const std::vector<Record>& records);

/// Pairs of single numbers of one kind, each of which lies where the other was simulated: they were exchanged.
/// `predicted`: of every reading of every record; `sigma`: SI, [record][channel].
std::vector<Misread> exchanged_numbers(const std::vector<Record>& records, const VectorXd& predicted,
                                       const std::vector<std::vector<double>>& sigma);

/// Readings of one value, five or more, that end with a leap, where the simulation moves all the while.
std::optional<Problem> held_readings(const Record& record, const Simulated& simulated);

/// Heights of a sphere that lie a radius, m, below what was simulated of its centre, in the middle of all of them or
/// where each record is lowest: those of its lowest point, no effect to be diagnosed.
std::optional<Problem> lowest_point(const std::vector<Record>& records, const VectorXd& predicted, double radius);

} // namespace tumble::diagnose
