#pragma once

#include "excitation/fit.h"
#include "excitation/record.h"

namespace tumble::excitation {

/// A record made ready for fits: thinned out where it was sampled far faster than the lines sought.
struct Samples {
    std::vector<Signal> signals; // parallel to the record's channels
    double spacing = 0;          // s
    double fine = 0;             // s, spacing of the record itself
    int thinning = 1;            // samples of the record per sample here

    /// Amplitude here over amplitude in the record, of a line at that frequency (Hz).
    [[nodiscard]] double gain(double frequency) const;
};

/// Each sample is a mean weighted as a triangle over 2 m - 1 of the record, m apart; m = 1: the record itself. The rate
/// stays at eight times `up_to` or more, so that what lies above folds back at less than 3 %.
Samples samples_of(const Record& record, double up_to);

} // namespace tumble::excitation
