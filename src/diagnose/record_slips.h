#pragma once

#include "diagnose/measurement.h"
#include "diagnose/signal.h"

#include <Eigen/Core>

namespace tumble::diagnose {

/// What was simulated of a record, and how well its readings are known.
struct Simulated {
    std::vector<Signal> truth; // a channel each
    std::vector<double> sigma; // SI, a channel each
};

/// Records over time that miss what was simulated by ten times their scatter and agree several times as well if they
/// are read otherwise than their file says: their time begins later or runs faster, they are of another record's
/// condition, a column's sign is turned, or it does not begin at 0. One sentence for each record, of what agrees best;
/// where one rate of time mends all of them, that alone. `simulated`: of each record.
Problems record_slips(const std::vector<Record>& records, const std::vector<Simulated>& simulated);

/// Pairs of single numbers of one kind, each of which lies where the other was simulated: they were exchanged.
/// `predicted`: of every reading of every record; `sigma`: SI, [record][channel].
Problems exchanged_numbers(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                           const std::vector<std::vector<double>>& sigma);

/// Heights of a sphere that lie a radius, m, below what was simulated of its centre, in the middle of all of them or
/// where each record is lowest: those of its lowest point, no effect to be diagnosed.
std::optional<Problem> lowest_point(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                                    double radius);

} // namespace tumble::diagnose
