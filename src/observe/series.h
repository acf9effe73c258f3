#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tumble::observe {

/// Numbers over time, column by column; the first column is time_s.
struct Series {
    std::vector<std::string> columns;        // heads, unit included
    std::vector<std::vector<double>> values; // per column, all of the same length

    [[nodiscard]] std::size_t rows() const { return values.empty() ? 0 : values.front().size(); }
    /// The column with this head, or the one whose head is this name followed by its unit; null when there is none.
    [[nodiscard]] const std::vector<double>* find(const std::string& name) const;
    void append(const std::vector<double>& row);
};

/// The unit that a column's head ends with, as heads write it: "m_s" of "tracer:ball_vx_m_s". Empty: none that is
/// known.
std::string unit_in(const std::string& head);

/// Writes a CSV file row by row. Each row reaches the system in one piece, so a killed run leaves whole lines; a row
/// that does not fit on the disk is taken back.
class SeriesWriter {
public:
    /// Creates the file with its head. Problems: it cannot be created or written.
    static Result<SeriesWriter> create(const std::filesystem::path& file, const std::vector<std::string>& columns);

    /// Opens a file whose first `size` bytes are whole rows under the head of these columns, and goes on behind them;
    /// what stands there is cut off. Problems: it is shorter than that, has another head, cannot be opened.
    static Result<SeriesWriter> go_on(const std::filesystem::path& file, const std::vector<std::string>& columns,
                                      std::uintmax_t size);

    SeriesWriter(SeriesWriter&& other) noexcept;
    SeriesWriter& operator=(SeriesWriter&& other) noexcept;
    ~SeriesWriter();

    /// One number per column, in the shortest form that reads back to the same bits; "nan" where there is none.
    /// Problems: wrong length, the disk is full.
    Result<Done> write(const std::vector<double>& row);

    /// Bytes of all whole rows so far and of the head.
    [[nodiscard]] std::uintmax_t size() const { return size_; }

private:
    SeriesWriter() = default;

    std::filesystem::path file_;
    std::size_t columns_ = 0;
    std::uintmax_t size_ = 0;
    int opened_ = -1;

    Result<Done> write_line(const std::string& line);
};

/// Reads what SeriesWriter wrote. A last line without its end (a run killed while writing) is left out. Problems, each
/// with its line: no head, a row of the wrong length, text that is no number.
Result<Series> read_series(const std::filesystem::path& file);

} // namespace tumble::observe
