#include "base/table.h"

#include "base/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <optional>

namespace tumble {
namespace {

constexpr std::size_t most_problems = 20;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

} // namespace

/// Walks the text once; cells are unquoted in place, which never makes them longer.
class TableParser {
public:
    TableParser(std::string text, std::string file, const TableLimits& limits) : limits_(limits) {
        table_.text_ = std::move(text);
        table_.file_ = std::move(file);
    }

    Result<Table> parse() {
        if (table_.text_.size() > std::min<std::size_t>(limits_.bytes, std::numeric_limits<std::uint32_t>::max()))
            return problem(0, 0, fmt::format("{} bytes are more than a table may have", table_.text_.size()),
                           fmt::format("split it, or leave rows out, to at most {} bytes", limits_.bytes));
        std::size_t begin = table_.text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        for (int line = 1; begin < table_.text_.size() && problems_.size() < most_problems && !full_; ++line) {
            const std::size_t end = std::min(table_.text_.find('\n', begin), table_.text_.size());
            take_line(line, begin, end);
            begin = end + 1;
        }
        if (problems_.empty() && table_.heads_.empty())
            problems_.push_back(problem(0, 0, "no head line: the file is empty",
                                        "begin with a line of column heads, such as time_s,speed_m_s"));
        if (!problems_.empty())
            return problems_;
        return std::move(table_);
    }

private:
    const TableLimits& limits_;
    Table table_;
    Problems problems_;
    std::vector<Table::Cell> row_;
    bool full_ = false;

    [[nodiscard]] Problem problem(int line, std::size_t column, std::string what, std::string fix) const {
        return {table_.file_, line, static_cast<int>(column), {}, std::move(what), std::move(fix)};
    }

    void take_line(int line, std::size_t begin, std::size_t end) {
        const std::string_view content = trimmed(std::string_view(table_.text_).substr(begin, end - begin));
        if (content.empty() || content.front() == '#')
            return;
        if (const auto nul = content.find('\0'); nul != std::string_view::npos) {
            const auto column = static_cast<std::size_t>(content.data() - table_.text_.data()) + nul - begin + 1;
            problems_.push_back(problem(line, column, "a NUL byte: this is not a text file", "give a CSV file"));
            return;
        }
        if (auto fault = cut(line, begin, end)) {
            problems_.push_back(std::move(*fault));
            return;
        }
        if (table_.heads_.empty())
            take_heads(line);
        else
            take_row(line);
    }

    /// Cuts the line into row_.
    std::optional<Problem> cut(int line, std::size_t begin, std::size_t end) {
        row_.clear();
        for (std::size_t at = begin;; ++at) {
            if (row_.size() == limits_.columns)
                return problem(line, at - begin + 1, fmt::format("more than {} cells in a line", limits_.columns),
                               "separate cells by ',' and rows by new lines");
            while (at < end && is_blank(at))
                ++at;
            const bool quoted = at < end && table_.text_[at] == '"';
            if (auto fault = quoted ? cut_quoted(line, begin, end, at) : cut_plain(begin, end, at))
                return fault;
            if (at >= end)
                return std::nullopt;
        }
    }

    [[nodiscard]] bool is_blank(std::size_t at) const {
        const char c = table_.text_[at];
        return c == ' ' || c == '\t' || c == '\r';
    }

    /// Leaves `at` on the comma behind the cell, or at the end of the line.
    std::optional<Problem> cut_plain(std::size_t begin, std::size_t end, std::size_t& at) {
        const std::size_t first = at;
        at = std::min(table_.text_.find(',', at), end);
        const auto size = trimmed(std::string_view(table_.text_).substr(first, at - first)).size();
        add_cell(first, size, first - begin + 1);
        return std::nullopt;
    }

    std::optional<Problem> cut_quoted(int line, std::size_t begin, std::size_t end, std::size_t& at) {
        const std::size_t first = ++at;
        std::string& text = table_.text_;
        std::size_t put = first;
        for (;; ++at) {
            if (at >= end)
                return problem(line, first - begin, "a quote that is not closed on its line", "close it with '\"'");
            if (text[at] == '"' && (++at >= end || text[at] != '"'))
                break;
            text[put++] = text[at];
        }
        while (at < end && is_blank(at))
            ++at;
        if (at < end && text[at] != ',')
            return problem(line, at - begin + 1, "text behind a closed quote", "put ',' between cells");
        add_cell(first, put - first, first - begin);
        return std::nullopt;
    }

    void add_cell(std::size_t begin, std::size_t size, std::size_t column) {
        row_.push_back(
            {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(column)});
    }

    void take_heads(int line) {
        table_.head_line_ = line;
        for (const Table::Cell& cell : row_) {
            std::string head = table_.text_.substr(cell.begin, cell.size);
            if (head.empty())
                problems_.push_back(problem(line, cell.column, "a column without a head", "name it, unit included"));
            else if (std::find(table_.heads_.begin(), table_.heads_.end(), head) != table_.heads_.end())
                problems_.push_back(problem(line, cell.column,
                                            fmt::format("two columns are called '{}'", excerpt(head)),
                                            "give each column its own head"));
            table_.heads_.push_back(std::move(head));
        }
        if (const std::string& only = table_.heads_[0];
            table_.heads_.size() == 1 && only.find_first_of(";\t") != std::string::npos) {
            problems_.push_back(problem(line, 0, "columns are separated by semicolons or tabs",
                                        "separate them by commas, and write numbers with a decimal point"));
            full_ = true;
        }
    }

    void take_row(int line) {
        if (row_.size() != table_.heads_.size()) {
            problems_.push_back(
                problem(line, row_.back().column,
                        fmt::format("{} cells where the head line has {}", row_.size(), table_.heads_.size()),
                        row_.size() == 2 * table_.heads_.size()
                            ? "give every row as many cells as the head line; if commas stand for decimal points, "
                              "write points"
                            : "give every row as many cells as the head line"));
            return;
        }
        if (table_.lines_.size() == limits_.rows) {
            problems_.push_back(problem(line, 0, fmt::format("more than {} rows", limits_.rows), "leave rows out"));
            full_ = true;
            return;
        }
        table_.cells_.insert(table_.cells_.end(), row_.begin(), row_.end());
        table_.lines_.push_back(line);
    }
};

Result<Table> parse_table(std::string text, std::string file, const TableLimits& limits) {
    return TableParser(std::move(text), std::move(file), limits).parse();
}

std::string_view Table::cell(std::size_t row, std::size_t column) const {
    const Cell& cell = cells_[row * heads_.size() + column];
    return std::string_view(text_).substr(cell.begin, cell.size);
}

Problem Table::problem_at(std::size_t row, std::size_t column, std::string what, std::string fix) const {
    const Cell& cell = cells_[row * heads_.size() + column];
    return {file_, lines_[row], static_cast<int>(cell.column), heads_[column], std::move(what), std::move(fix)};
}

Result<std::size_t> Table::find(std::string_view head) const {
    if (const auto found = std::find(heads_.begin(), heads_.end(), head); found != heads_.end())
        return static_cast<std::size_t>(found - heads_.begin());
    std::string fix = did_you_mean(head, heads_);
    if (fix.empty())
        fix = fmt::format("the columns are {}", excerpt(fmt::format("{}", fmt::join(heads_, ", ")), 300));
    return Problem{file_,         head_line_, 0, std::string(head), fmt::format("no column '{}'", excerpt(head)),
                   std::move(fix)};
}

Result<std::vector<double>> Table::numbers(std::string_view head) const {
    const auto column = find(head);
    if (!column)
        return column.problems();
    std::vector<double> values;
    values.reserve(rows());
    Problems problems;
    for (std::size_t row = 0; row < rows() && problems.size() < most_problems; ++row) {
        const auto number = parse_number(cell(row, *column));
        if (number) {
            values.push_back(*number);
            continue;
        }
        const Problem inner = number.problems().front();
        const std::string_view text = cell(row, *column);
        problems.push_back(problem_at(row, *column, text.empty() ? "an empty cell is no number" : inner.what,
                                      text.empty() ? "give the number, or leave the row out"
                                      : text.find(',') != std::string_view::npos ? "write a point, not a comma, before "
                                                                                   "decimals"
                                      : text.find(':') != std::string_view::npos
                                          ? "write a time of day as one number of "
                                            "seconds"
                                          : inner.fix));
    }
    if (!problems.empty())
        return problems;
    return values;
}

Result<std::vector<double>> Table::quantity(std::string_view name, std::span<const Unit> units) const {
    std::vector<std::string> accepted;
    for (const Unit& unit : units) {
        accepted.push_back(fmt::format("{}_{}", name, unit.name));
        if (std::find(heads_.begin(), heads_.end(), accepted.back()) == heads_.end())
            continue;
        auto values = numbers(accepted.back());
        if (values)
            for (double& value : *values)
                value *= unit.si;
        return values;
    }
    const bool named_whole = std::find(heads_.begin(), heads_.end(), name) != heads_.end();
    std::vector<std::string> stems; // of heads in these units
    for (const std::string& head : heads_)
        for (const Unit& unit : units)
            if (const std::string end = fmt::format("_{}", unit.name); head.ends_with(end))
                stems.push_back(head.substr(0, head.size() - end.size()));
    const std::string meant = did_you_mean(name, stems);
    const bool has_unit = std::any_of(units.begin(), units.end(),
                                      [&](const Unit& unit) { return name.ends_with(fmt::format("_{}", unit.name)); });
    return Problem{file_,
                   head_line_,
                   0,
                   std::string(name),
                   fmt::format("no column for {}", name),
                   named_whole && has_unit
                       ? fmt::format("leave the unit out of the name: \"{}\"", name.substr(0, name.rfind('_')))
                   : !meant.empty() && !named_whole ? meant
                   : named_whole ? fmt::format("say its unit in the head line: {}", fmt::join(accepted, " or "))
                                 : fmt::format("call it {}; there {} {}", fmt::join(accepted, " or "),
                                               heads_.size() == 1 ? "is" : "are",
                                               excerpt(fmt::format("{}", fmt::join(heads_, ", "))))};
}

std::string csv_line(std::span<const std::string> cells) {
    std::string line;
    for (const std::string& cell : cells) {
        if (!line.empty() || &cell != cells.data())
            line += ',';
        const bool plain = cell.find_first_of(",\"#\r\n") == std::string::npos && !cell.starts_with(byte_order_mark);
        if (plain && trimmed(cell).size() == cell.size()) {
            line += cell;
            continue;
        }
        line += '"';
        for (const char c : cell) {
            if (c == '"')
                line += '"';
            line += c == '\n' ? ' ' : c;
        }
        line += '"';
    }
    // A line with nothing on it is no row.
    return line.empty() ? "\"\"\n" : line + '\n';
}

std::string csv_line(std::span<const double> numbers) {
    std::string line;
    for (const double number : numbers) {
        if (!line.empty())
            line += ',';
        line += shortest(number);
    }
    return line + '\n';
}

} // namespace tumble
