#include "scene/read_table.h"

#include "base/table.h"
#include "base/text.h"
#include "scene/keys.h"
#include "scene/lines.h"
#include "scene/read_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace tumble::scene {
namespace {

constexpr TableLimits limits{.bytes = std::size_t{64} << 20, .rows = 2'000'000, .columns = 8};
constexpr std::size_t most_harmonics = 10'000;
constexpr double longest_time = 1e6; // s
constexpr double farthest_way = 100; // m
constexpr const char* table_form =
    "write the head t_s,x_m,y_m,z_m and rows of time (s, from 0, rising) and displacement (m)";
constexpr const char* flat_table_form =
    "write the head t_s,x_m,y_m and rows of time (s, from 0, rising) and displacement (m)";
constexpr const char* harmonics_form =
    "write the head axis,amplitude,period (and phase_deg) and rows such as y,0.002,0.04";

/// A table whose heads are exactly these, the last `optional` of them perhaps missing.
Result<tumble::Table> table_with(std::string_view text, const std::string& source, std::vector<std::string> heads,
                                 std::size_t optional, const char* form) {
    auto table = parse_table(std::string(text), source, limits);
    if (!table)
        return table;
    std::vector<std::string> short_heads(heads.begin(), heads.end() - static_cast<std::ptrdiff_t>(optional));
    if (table->heads() != heads && table->heads() != short_heads)
        return Problem{source,
                       0,
                       0,
                       "",
                       fmt::format("the head is '{}', not '{}'",
                                   excerpt(fmt::format("{}", fmt::join(table->heads(), ","))),
                                   fmt::join(short_heads, ",")),
                       form};
    return table;
}

/// Columns of numbers of one table, with the problems of all of them.
class Columns {
public:
    Columns(const tumble::Table& table, const char* form) : table_(table), form_(form) {}

    std::vector<double> read(std::string_view head, double lo, double hi) {
        const std::size_t column = *table_.find(head);
        std::vector<double> numbers(table_.rows());
        auto read = table_.numbers(head);
        if (!read) {
            const Problems more = read.problems();
            problems_.insert(problems_.end(), more.begin(), more.end());
            return numbers;
        }
        for (std::size_t row = 0; row < table_.rows(); ++row)
            if (!((*read)[row] >= lo && (*read)[row] <= hi))
                refuse(row, column,
                       fmt::format("{} is not within {} to {}", plain((*read)[row]), plain(lo), plain(hi)));
        return std::move(*read);
    }

    void refuse(std::size_t row, std::size_t column, std::string what) {
        if (problems_.size() < most_problems)
            problems_.push_back(table_.problem_at(row, column, std::move(what), form_));
    }

    [[nodiscard]] const Problems& problems() const { return problems_; }

private:
    const tumble::Table& table_;
    const char* form_;
    Problems problems_;
};

} // namespace

std::vector<RowFault> time_faults(const std::vector<double>& time) {
    std::vector<RowFault> faults;
    if (time.size() < 2)
        faults.push_back({0, fmt::format("a motion of {} row, it needs 2", time.size())});
    if (!time.empty() && time[0] != 0)
        faults.push_back({0, fmt::format("the first time is {}, not 0", plain(time[0]))});
    for (std::size_t row = 1; row < time.size(); ++row)
        if (!(time[row] > time[row - 1]))
            faults.push_back(
                {row, fmt::format("time {} does not rise above {}", plain(time[row]), plain(time[row - 1]))});
    return faults;
}

Result<MotionTable> parse_motion_table(std::string_view text, const std::string& source, int dimension) {
    const char* const form = dimension == 2 ? flat_table_form : table_form;
    std::vector<std::string> heads{"t_s", "x_m", "y_m", "z_m"};
    heads.resize(static_cast<std::size_t>(dimension) + 1);
    const auto table = table_with(text, source, heads, 0, form);
    if (!table)
        return table.problems();
    if (table->rows() == 0)
        return Problem{source, 0, 0, "", "there is no row below the head", form};
    Columns columns(*table, form);
    MotionTable motion;
    motion.time = columns.read("t_s", 0, longest_time);
    std::array<std::vector<double>, 3> along;
    along.fill(std::vector<double>(table->rows(), 0.0));
    for (std::size_t k = 0; k + 1 < heads.size(); ++k)
        along[k] = columns.read(heads[k + 1], -farthest_way, farthest_way);
    if (!columns.problems().empty())
        return columns.problems();
    for (const RowFault& fault : time_faults(motion.time))
        columns.refuse(fault.row, 0, fault.what);
    if (!columns.problems().empty())
        return columns.problems();
    for (std::size_t row = 0; row < table->rows(); ++row)
        motion.displacement.emplace_back(along[0][row], along[1][row], along[2][row]);
    return motion;
}

Result<std::vector<Harmonic>> parse_harmonics(std::string_view text, const std::string& source) {
    const auto table = table_with(text, source, {"axis", "amplitude", "period", "phase_deg"}, 1, harmonics_form);
    if (!table)
        return table.problems();
    if (table->rows() == 0 || table->rows() > most_harmonics)
        return Problem{source,        0, 0, "", fmt::format("{} harmonics, not 1 to {}", table->rows(), most_harmonics),
                       harmonics_form};
    Columns columns(*table, harmonics_form);
    const auto amplitude = columns.read("amplitude", 0, farthest_way);
    const auto period = columns.read("period", 1e-6, longest_time);
    const auto phase =
        table->heads().size() > 3 ? columns.read("phase_deg", -360, 360) : std::vector<double>(table->rows(), 0.0);
    std::vector<Harmonic> harmonics(table->rows());
    for (std::size_t row = 0; row < table->rows(); ++row) {
        const std::string_view axis = table->cell(row, 0);
        if (axis != "x" && axis != "y" && axis != "z")
            columns.refuse(row, 0, fmt::format("'{}' is not an axis x, y or z", excerpt(axis)));
        else
            harmonics[row].axis = axis[0] - 'x';
        harmonics[row].amplitude = amplitude[row];
        harmonics[row].frequency = 1 / period[row];
        harmonics[row].phase = phase[row] * std::numbers::pi / 180;
    }
    if (!columns.problems().empty())
        return columns.problems();
    return harmonics;
}

Result<MotionTable> read_motion_table(const std::filesystem::path& file, int dimension) {
    const auto text = read_file(file, limits.bytes);
    if (!text)
        return text.problems();
    return parse_motion_table(*text, file.string(), dimension);
}

Result<std::vector<Harmonic>> read_harmonics(const std::filesystem::path& file) {
    const auto text = read_file(file, limits.bytes);
    if (!text)
        return text.problems();
    return parse_harmonics(*text, file.string());
}

} // namespace tumble::scene
