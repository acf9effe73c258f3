#pragma once

#include <cstddef>
#include <vector>

namespace tumble::diagnose {

/// One measure over time as a simulation gave it, dense enough to be read between its rows.
struct Signal {
    std::vector<double> time; // s, rising, two rows or more
    std::vector<double> value;

    /// Third-order polynomial through the four rows around t; the first and last value are held beyond the ends. A kink
    /// between two rows, as an impact leaves it that is over in less than a row, stays sharp, and no polynomial crosses
    /// it.
    [[nodiscard]] double at(double t) const;
    /// Change per second about t, over one row to either side.
    [[nodiscard]] double rate_at(double t) const;
    /// The same passed through a first-order low pass of that time constant (s), exactly for straight lines between
    /// rows; it starts at `from`.
    [[nodiscard]] Signal low_passed(double time_constant, double from) const;

private:
    /// Second divided difference at row k.
    [[nodiscard]] double bend(std::size_t k) const;
    /// Between rows k and k + 1 the slope jumps.
    [[nodiscard]] bool kinked(std::size_t k) const;
    /// Polynomial through these rows.
    [[nodiscard]] double through(std::size_t first, std::size_t last, double t) const;
};

} // namespace tumble::diagnose
