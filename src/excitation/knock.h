#pragma once

#include "excitation/lines.h"

#include <vector>

/// Natural frequencies from knocks with a hammer on a machine at rest.
namespace tumble::excitation {

struct Mode {
    double frequency = 0, frequency_se = 0; // Hz, undamped: sqrt(f_d^2 + (decay / 2 pi)^2)
    double damping = 0, damping_se = 0;     // of critical
    std::vector<double> largest;            // m/s2, amplitude at the knock that moved it most, per channel
};

struct Ringing {
    std::vector<double> knocks; // s
    std::vector<Mode> modes;    // rising
    Problems warnings;
};

/// What rings between the knocks: damped waves of common frequencies and decays with amplitudes of their own after each
/// knock, by least squares. Problems: no knock, nothing that rings.
Result<Ringing> find_modes(const Record& record, const Settings& settings);

} // namespace tumble::excitation
