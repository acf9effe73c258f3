#include "observe/series.h"

#include "base/remedy.h"
#include "base/text.h"
#include "base/write_all.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <sstream>
#include <unistd.h>
#include <utility>

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
            .fix = remedy(error)};
}

Result<double> read_cell(std::string_view cell) {
    if (cell == "nan")
        return std::numeric_limits<double>::quiet_NaN();
    return parse_number(trimmed(cell));
}

const std::vector<std::string> units{"J", "m", "deg", "rad_s", "m_s", "m_s2", "s"};

} // namespace

std::string unit_in(const std::string& head) {
    std::string longest; // "m_s", not "s"
    for (const std::string& unit : units)
        if (head.ends_with("_" + unit) && unit.size() > longest.size())
            longest = unit;
    return longest;
}

const std::vector<double>* Series::find(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] == name)
            return &values[i];
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (const std::string& unit : units)
            if (columns[i] == fmt::format("{}_{}", name, unit))
                return &values[i];
    return nullptr;
}

void Series::append(const std::vector<double>& row) {
    values.resize(columns.size());
    for (std::size_t i = 0; i < columns.size() && i < row.size(); ++i)
        values[i].push_back(row[i]);
}

SeriesWriter::SeriesWriter(SeriesWriter&& other) noexcept {
    *this = std::move(other);
}

SeriesWriter& SeriesWriter::operator=(SeriesWriter&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(columns_, other.columns_);
    std::swap(size_, other.size_);
    std::swap(opened_, other.opened_);
    return *this;
}

SeriesWriter::~SeriesWriter() {
    if (opened_ >= 0)
        ::close(opened_);
}

Result<SeriesWriter> SeriesWriter::create(const std::filesystem::path& file, const std::vector<std::string>& columns) {
    SeriesWriter writer;
    writer.file_ = file;
    writer.columns_ = columns.size();
    writer.opened_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (writer.opened_ < 0)
        return cannot_write(file, errno);
    if (const auto written = writer.write_line(joined(columns)); !written)
        return written.problems();
    return writer;
}

Result<SeriesWriter> SeriesWriter::go_on(const std::filesystem::path& file, const std::vector<std::string>& columns,
                                         std::uintmax_t size) {
    const Problem other{.file = file.string(),
                        .what = "is not what the run wrote so far: it is shorter, or has other columns",
                        .fix = "put it back as the run left it, or run the scene again"};
    const std::string head = joined(columns);
    std::string start(head.size(), '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(start.data(), static_cast<std::streamsize>(start.size()));
    std::error_code error;
    if (!stream || start != head || size < head.size() || std::filesystem::file_size(file, error) < size || error)
        return other;
    SeriesWriter writer;
    writer.file_ = file;
    writer.columns_ = columns.size();
    writer.size_ = size;
    writer.opened_ = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    const auto end = static_cast<off_t>(size);
    if (writer.opened_ < 0 || ::ftruncate(writer.opened_, end) != 0 || ::lseek(writer.opened_, end, SEEK_SET) != end)
        return cannot_write(file, errno);
    return writer;
}

Result<Done> SeriesWriter::write_line(const std::string& line) {
    const int error = write_all(opened_, line);
    if (error == 0) {
        size_ += line.size();
        return Done{};
    }
    const auto end = static_cast<off_t>(size_);
    if (::ftruncate(opened_, end) == 0)
        ::lseek(opened_, end, SEEK_SET);
    return cannot_write(file_, error);
}

Result<Done> SeriesWriter::write(const std::vector<double>& row) {
    if (row.size() != columns_)
        return Problem{.file = file_.string(),
                       .what = fmt::format("a row of {} numbers for {} columns", row.size(), columns_)};
    std::vector<std::string> cells;
    for (const double value : row)
        cells.push_back(std::isfinite(value) ? shortest(value + 0.0) : "nan"); // 0, never -0
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
