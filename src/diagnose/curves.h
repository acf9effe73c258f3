#pragma once

#include "diagnose/noise.h"

#include <string>
#include <vector>

namespace tumble::diagnose {

/// One channel of one record beside what the simulation says of it.
struct Curve {
    std::string record, condition, head, unit;
    double sigma = 0;                                       // SI
    std::vector<double> time, measured, baseline, extended; // extended: empty where nothing is named
    std::vector<bool> left_out;                             // lone outliers
    std::string measure{};                                  // "centre_of_mass_y"
    double stated = 0;                                      // SI, sigma as the measurement has it; 0: not stated
    double shaken = 0;      // s, period of the slowest vibration of a wall; 0: none vibrates
    double shaken_from = 0; // s, where its phase is 0, on the instrument's clock
};

/// Where a sensor that clips cuts its readings off, to either side of zero.
struct Cut {
    std::string head, unit;
    double limit = 0; // SI
};

/// Of every column that is cut at these values, one of each head.
std::vector<Cut> cuts_of(Model& model, const VectorXd& values);

/// Every channel of every record, with the baseline's values and those of an extended fit (null: there is none). Empty
/// where they cannot be simulated.
std::vector<Curve> curves_of(Model& model, const Noise& noise, const VectorXd& baseline, const VectorXd* extended);

} // namespace tumble::diagnose
