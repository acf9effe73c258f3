#pragma once

#include "excitation/record.h"

#include <optional>
#include <vector>

namespace tumble::excitation {

struct Settings {
    double motor = 0;   // Hz, nominal; the fundamental is looked for within 8 % of it. 0: the strongest line
    double up_to = 250; // Hz, highest line looked for
    double mains = 50;  // Hz
    double bin = 0;     // Hz, width of a list's bins; 0: the widest that all its lines are multiples of
};

/// What a line is.
enum class Kind {
    order,   // n/2 of the fundamental
    mains,   // a multiple of the mains frequency
    unclear, // an order and a multiple of the mains that the record is too short to tell apart
    other    // neither: a mode, another machine
};

/// A line on one channel: a sin(2 pi f (t - reference) + phase).
struct Component {
    double acceleration = 0, acceleration_se = 0; // m/s2
    double phase = 0, phase_se = 0;               // rad
    double beside_se = 0;                         // rad, of phase where the frequency is common: for differences
    bool seen = false;                            // above the noise
};

struct Line {
    Kind kind = Kind::other;
    int halves = 0;                         // an order is halves / 2 of the fundamental
    int multiple = 0;                       // of the mains
    double frequency = 0, frequency_se = 0; // Hz
    std::vector<Component> on;              // parallel to the record's channels
};

struct Excitation {
    double fundamental = 0, fundamental_se = 0; // Hz
    double reference = 0;                       // s, where phases count from: the record's first sample
    double resolution = 0;                      // Hz, 1 / duration
    std::vector<Line> lines;                    // rising
    std::vector<double> offset;                 // m/s2, mean per channel: gravity, or the amplifier's zero
    std::vector<double> noise;                  // m/s2, standard deviation of what is left per channel
    double explained = 0;                       // share of all power about the mean that the lines hold
    Problems warnings;

    /// The order 1.
    [[nodiscard]] const Line& first_order() const;
};

/// Frequency, amplitude and phase of every line by least squares: one fundamental for all orders and half orders, a
/// frequency of its own for every other line; never an FFT bin. Problems: no line stands out of the noise, fewer than
/// three periods.
Result<Excitation> find_lines(const Record& record, const Settings& settings);

/// The speed of an induction motor's field, mains / pole pairs, that this one lags behind by at most 8 %; none when
/// there is none.
struct Slip {
    int pole_pairs = 0;
    double synchronous = 0; // Hz
};
std::optional<Slip> slip_of(double fundamental, double mains);

} // namespace tumble::excitation
