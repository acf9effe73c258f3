#include "observe/series.h"

#include "base/text.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <sstream>
#include <unistd.h>

namespace tumble::observe {

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
        if (!line.empty())
            line += ',';
        line += word;
    }
    line += '\n';
    return line;
}

Problem cannot_write(const std::filesystem::path& file, int error) {
    return {.file = file.string(),
            .what = fmt::format("cannot be written: {}", std::strerror(error)),
            .fix = error == ENOSPC ? "free some space, or write to another disk" : "write to a folder that is yours"};
}

Result<double> read_cell(std::string_view cell) {
    if (cell == "nan")
        return std::numeric_limits<double>::quiet_NaN();
    return parse_number(trimmed(cell));
}

} // namespace

const std::vector<double>* Series::find(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] == name)
            return &values[i];
    static const std::vector<std::string> units{"J", "m", "deg", "rad_s", "m_s", "m_s2", "s"};
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (const std::string& unit : units)
            if (columns[i] == name + "_" + unit)
                return &values[i];
    return nullptr;
}

void Series::append(const std::vector<double>& row) {
    values.resize(columns.size());
    for (std::size_t i = 0; i < columns.size() && i < row.size(); ++i)
        values[i].push_back(row[i]);
}

Result<SeriesWriter> SeriesWriter::create(const std::filesystem::path& file, const std::vector<std::string>& columns) {
    SeriesWriter writer;
    writer.file_ = file;
    writer.columns_ = columns.size();
    writer.stream_.reset(std::fopen(file.c_str(), "wb"));
    if (!writer.stream_)
        return cannot_write(file, errno);
    std::setvbuf(writer.stream_.get(), nullptr, _IONBF, 0);
    if (const auto written = writer.write_line(joined(columns)); !written)
        return written.problems();
    return writer;
}

Result<Done> SeriesWriter::write_line(const std::string& line) {
    const long before = std::ftell(stream_.get());
    errno = 0;
    const std::size_t written = std::fwrite(line.data(), 1, line.size(), stream_.get());
    if (written == line.size())
        return Done{};
    const int error = errno;
    std::clearerr(stream_.get());
    if (before >= 0 && ftruncate(fileno(stream_.get()), before) == 0)
        std::fseek(stream_.get(), before, SEEK_SET);
    return cannot_write(file_, error);
}

Result<Done> SeriesWriter::write(const std::vector<double>& row) {
    if (row.size() != columns_)
        return Problem{.file = file_.string(),
                       .what = fmt::format("a row of {} numbers for {} columns", row.size(), columns_)};
    std::vector<std::string> cells;
    for (const double value : row)
        cells.push_back(std::isfinite(value) ? shortest(value) : "nan");
    return write_line(joined(cells));
}

Result<Series> read_series(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::stringstream content;
    if (!stream || !(content << stream.rdbuf()))
        return Problem{.file = file.string(), .what = "cannot be read", .fix = "is this the folder of a run?"};
    const std::string text = content.str();
    const std::string whole = text.substr(0, text.rfind('\n') + 1);
    if (whole.empty())
        return Problem{.file = file.string(), .line = 1, .what = "has no line with the names of its columns"};
    Series series;
    Problems problems;
    int line = 0;
    for (const std::string_view row : split(std::string_view(whole).substr(0, whole.size() - 1), '\n')) {
        ++line;
        const std::vector<std::string_view> cells = split(trimmed(row), ',');
        if (line == 1) {
            series.columns.assign(cells.begin(), cells.end());
            series.values.resize(cells.size());
            continue;
        }
        if (cells.size() != series.columns.size()) {
            problems.push_back({.file = file.string(),
                                .line = line,
                                .what = fmt::format("{} numbers for {} columns", cells.size(), series.columns.size())});
            continue;
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Result<double> value = read_cell(cells[i]);
            if (value)
                series.values[i].push_back(*value);
            else
                problems.push_back(
                    {.file = file.string(),
                     .line = line,
                     .what = fmt::format("'{}' in column {} is no number", cells[i], series.columns[i])});
        }
    }
    if (!problems.empty())
        return problems;
    return series;
}

} // namespace tumble::observe
