#pragma once

#include "excitation/lines.h"

#include <filesystem>
#include <string_view>

/// What a printed list of lines still tells when every frequency was rounded to the bins of a transform.
namespace tumble::excitation {

/// One row of the list, and what it may be.
struct BinnedLine {
    int axis = 0;
    double amplitude = 0; // m
    double frequency = 0; // Hz, as printed
    long long bin = 0;    // frequency / width of a bin
    int halves = 0;       // of the fundamental: an order is halves / 2; 0: fits none
    int multiple = 0;     // of the mains; 0: fits none
};

struct Interval {
    double lo = 0, hi = 0;
};

struct BinnedLines {
    double bin = 0; // Hz, width: 1 / duration of the record
    std::vector<BinnedLine> lines;
    Interval fundamental;       // Hz, all that every order's bin allows
    double nominal = 0;         // Hz, the printed frequency of the strongest line
    std::size_t orders = 0;     // different bins that the interval explains
    std::size_t at_nominal = 0; // and that `nominal` itself explains
    double chance = 0;          // that bin errors of up to two either way, all alike, agree on any fundamental
};

/// A list of harmonics as scene::parse_harmonics takes it ("axis,amplitude,period"), phases unknown. Every line is
/// taken to be within half a bin of the truth; the fundamental is where most of their intervals, divided by the order,
/// overlap. Problems: those of the reader, frequencies that are no multiples of one bin width, fewer than three lines.
Result<BinnedLines> find_slip(std::string_view text, const std::string& source, const Settings& settings);

/// A list of lines and not a record: its head begins with "axis,amplitude,period".
bool is_line_list(std::string_view text);

/// Share of its amplitude that a line shows whose frequency lies `off` bins beside the bin's middle (|off| <= 0.5).
double shown_without_window(double off);
double shown_with_hann(double off);

} // namespace tumble::excitation
