#pragma once

#include "base/problem.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// What a table may hold at most, so that a wrong file ends in a sentence and not in a full memory.
struct TableLimits {
    std::size_t bytes = std::size_t{256} << 20;
    std::size_t rows = 20'000'000;
    std::size_t columns = 1'000;
};

/// A unit that a column head may end in, and what one of it is in SI.
struct Unit {
    std::string name; // "mm"
    double si = 1;    // 1e-3
};

/// Rows of cells as a CSV file holds them: a head line, then rows of as many cells. Lines that begin with '#' and empty
/// lines are left out; cells are trimmed; "..." keeps commas and blanks, "" inside is one quote. Cells are views into
/// the table's own text.
class Table {
public:
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] const std::vector<std::string>& heads() const { return heads_; }
    [[nodiscard]] std::size_t rows() const { return lines_.size(); }
    [[nodiscard]] std::string_view cell(std::size_t row, std::size_t column) const;

    /// Index of the column with this head. Problem: there is none; says which heads there are and which is near.
    [[nodiscard]] Result<std::size_t> find(std::string_view head) const;

    /// All cells under this head as finite numbers. Problems: no such head; every cell that is no number, by line and
    /// column (the first twenty).
    [[nodiscard]] Result<std::vector<double>> numbers(std::string_view head) const;

    /// The column `name`_`unit` for the one of `units` that the head names, in SI. Problems: as numbers().
    [[nodiscard]] Result<std::vector<double>> quantity(std::string_view name, std::span<const Unit> units) const;

    /// A problem at one cell, for checks that only the reader of the numbers can make.
    [[nodiscard]] Problem problem_at(std::size_t row, std::size_t column, std::string what, std::string fix) const;

private:
    friend class TableParser;

    struct Cell {
        std::uint32_t begin = 0, size = 0; // in text_, after unquoting
        std::uint32_t column = 0;          // in the line, from 1, as written
    };

    std::string file_;
    std::string text_;
    std::vector<std::string> heads_;
    std::vector<Cell> cells_; // row-major
    std::vector<int> lines_;  // per row, from 1
    int head_line_ = 0;
};

/// Reads a table from the text of a file; `file` is what problems name. Problems, with line and column: no head line,
/// an empty or repeated head, a row with too many or too few cells, a quote that is not closed on its line, text that
/// is not text (NUL bytes), more than `limits` allow.
Result<Table> parse_table(std::string text, std::string file, const TableLimits& limits = {});

/// One line of CSV, ended by a newline; cells with commas, quotes, '#' or outer blanks are quoted, new lines
/// inside a cell become blanks because the reader takes one row a line.
std::string csv_line(std::span<const std::string> cells);

/// One line of CSV, each number in the shortest form that reads back to the same bits.
std::string csv_line(std::span<const double> numbers);

} // namespace tumble
