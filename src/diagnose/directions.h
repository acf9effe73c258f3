#pragma once

#include "diagnose/fit.h"
#include "diagnose/swings.h"

namespace tumble::diagnose {

/// Of a direction of length 1: what a fit has left less of is rounding.
constexpr double nearly_used_up = 1e-3;

/// Directions in which a residual may differ from noise whatever the cause, in rows as a Fit has them.
struct Directions {
    MatrixXd blocks; // means over pieces of a record: one half of a flight between two impacts
    MatrixXd prints; // what effects usually follow: reading, speed, time, number of impacts, conditions one by one
    std::vector<std::string> names{}; // of prints, for sentences; none where nobody asks
    std::vector<std::string> own{}; // of prints: what would differ in one condition only, the same for all; else empty
    std::vector<int> condition;     // of each row, -1 for priors
    std::vector<std::string> conditions;
    std::vector<Course> courses{};    // where swings are looked for; none of means
    VectorXd lengths{};               // of prints before each was brought to length 1; empty: nobody asks
    std::vector<std::string> units{}; // of prints: of the residual's slope along each, as people write it
};

/// About a fit of the baseline: `slopes` are those of its parameters `free`.
Result<Directions> directions_at(Model& model, const Noise& noise, const Fit& fit);

/// Impacts of a signal, s: instants where it turns upwards in less than a few rows.
std::vector<double> impacts_of(const Signal& signal, double shortest_flight);

} // namespace tumble::diagnose
