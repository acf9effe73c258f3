#pragma once

#include <vector>

namespace tumble::diagnose {

/// One measure over time as a simulation gave it, dense enough to be read between its rows.
struct Signal {
    std::vector<double> time; // s, rising, two rows or more
    std::vector<double> value;

    /// Third-order polynomial through the four rows around t; the first and last value are held beyond the ends.
    [[nodiscard]] double at(double t) const;
    /// Change per second about t, over one row to either side.
    [[nodiscard]] double rate_at(double t) const;
    /// The same passed through a first-order low pass of that time constant (s), exactly for straight lines between
    /// rows; it starts at `from`.
    [[nodiscard]] Signal low_passed(double time_constant, double from) const;
};

} // namespace tumble::diagnose
