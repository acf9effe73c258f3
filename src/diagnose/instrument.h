#pragma once

#include "diagnose/signal.h"

#include <span>
#include <vector>

namespace tumble::diagnose {

/// What stands between an experiment and its record. All zero: a perfect instrument. It acts on the simulated signal;
/// data are never "corrected".
struct Instrument {
    double clock_offset = 0; // s, of the experiment's start on the instrument's clock
    double clock_rate = 0;   // -, share by which the clock runs fast
    double gain = 0;         // -, share by which the scale reads too much
    double bias = 0;         // unit of the channel, added
    double low_pass = 0;     // s, time constant of a first-order filter
    double high_pass = 0;    // 1/s, 2 pi times the corner frequency; it begins to forget when the record begins
    double drift = 0;        // unit of the channel per second
    double clipping = 0;     // -, share of the largest magnitude that lies beyond its range, either sign
};

/// What such an instrument shows at these times of its own clock. `largest`: magnitude of all signals of this kind that
/// it is used for, whose one range clips them all.
std::vector<double> seen_through(const Instrument& instrument, const Signal& truth, std::span<const double> times,
                                 double largest = 0);

/// The same for the experiment's time itself, as a clock in the picture shows it: only clocks act on it.
std::vector<double> clock_seen_through(const Instrument& instrument, std::span<const double> times);

} // namespace tumble::diagnose
