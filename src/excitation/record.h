#pragma once

#include "base/problem.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// From what an accelerometer recorded to how a wall moves.
namespace tumble::excitation {

/// One axis of one sensor.
struct Channel {
    std::string name;           // "ax"
    int axis = 0;               // 0 x, 1 y, 2 z
    int sensor = 0;             // 0 the first, 1 the second
    std::vector<double> values; // m/s2
};

struct Record {
    std::string file;
    std::vector<double> time;      // s, rising
    std::vector<Channel> channels; // each as long as time
    Problems warnings;             // what the reader should know, by line; none of it keeps the record from being used

    [[nodiscard]] double step() const; // s, between samples, the middle one
    [[nodiscard]] double duration() const { return time.back() - time.front(); }
};

/// CSV with a column of time (t_s, t_ms, t_us; or time_s, ...) and one to three of acceleration (ax_m_s2, ax_mm_s2 or
/// ax_g; ay, az alike). Problems, by line: a cell that is no finite number, time that does not rise, a column equal to
/// another, no such columns, fewer than 64 rows. Warnings: uneven sampling, gaps, clipping, few levels, a dead
/// channel, units that can hardly be.
Result<Record> parse_record(std::string text, const std::string& source);
Result<Record> read_record(const std::filesystem::path& file);

/// The channels of two sensors that one instrument sampled at the same instants, so that their phases can be compared.
/// Problem: the times differ.
Result<Record> together(Record first, const Record& second);

} // namespace tumble::excitation
