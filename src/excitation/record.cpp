#include "excitation/record.h"

#include "base/column.h"
#include "base/table.h"
#include "base/text.h"
#include "scene/read_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tumble::excitation {

namespace {

constexpr std::size_t fewest_rows = 64;
constexpr std::size_t most_problems = 20;
constexpr std::size_t few_levels = 50;
constexpr std::size_t clipped_run = 3;
constexpr double uneven = 0.01;              // of the usual step
constexpr double standard_gravity = 9.80665; // m/s2

const std::array<Unit, 3> time_units{{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}}};
const std::array<Unit, 3> acceleration_units{{{"m_s2", 1}, {"g", standard_gravity}, {"mm_s2", 1e-3}}};

/// Reads one table; `problems` end it, `warnings` do not.
class Reader {
public:
    explicit Reader(const Table& table) : table_(table) {}

    Result<Record> read() {
        record_.file = table_.file();
        read_time();
        for (int axis = 0; axis < 3; ++axis)
            read_axis(axis);
        if (problems_.empty() && record_.channels.empty())
            problems_.push_back({.file = table_.file(),
                                 .what = "no column of acceleration",
                                 .fix = "call the columns ax_m_s2, ay_m_s2, az_m_s2 (or _g, _mm_s2)"});
        if (problems_.empty() && table_.rows() < fewest_rows)
            problems_.push_back({.file = table_.file(),
                                 .what = fmt::format("{} rows, too few to find a frequency", table_.rows()),
                                 .fix = fmt::format("record at least {} samples", fewest_rows)});
        if (problems_.empty())
            check_time();
        if (problems_.empty())
            check_channels();
        if (!problems_.empty())
            return problems_;
        return std::move(record_);
    }

private:
    /// The column that a head "name_unit" names; none when no head begins so.
    std::optional<std::size_t> column_of(const std::string& name) const {
        for (std::size_t k = 0; k < table_.heads().size(); ++k)
            if (table_.heads()[k].starts_with(name + "_"))
                return k;
        return std::nullopt;
    }

    std::vector<double> numbers(const std::string& name, std::span<const Unit> units) {
        Result<std::vector<double>> values = table_.quantity(name, units);
        if (values)
            return std::move(*values);
        for (const Problem& problem : values.problems())
            if (problems_.size() < most_problems)
                problems_.push_back(problem);
        return {};
    }

    void read_time() {
        const bool spelled = column_of("time").has_value();
        time_column_ = column_of(spelled ? "time" : "t").value_or(0);
        record_.time = numbers(spelled ? "time" : "t", time_units);
    }

    void read_axis(int axis) {
        const std::string name = fmt::format("a{}", "xyz"[axis]);
        const auto column = column_of(name);
        if (!column)
            return;
        columns_.push_back(*column);
        record_.channels.push_back({name, axis, 0, numbers(name, acceleration_units)});
    }

    void refuse(std::size_t row, std::size_t column, std::string what, std::string fix) {
        if (problems_.size() < most_problems)
            problems_.push_back(table_.problem_at(row, column, std::move(what), std::move(fix)));
    }
    void warn(std::size_t row, std::size_t column, std::string what, std::string fix) {
        record_.warnings.push_back(table_.problem_at(row, column, std::move(what), std::move(fix)));
    }

    void check_time() {
        const std::vector<double>& time = record_.time;
        for (std::size_t row = 1; row < time.size(); ++row)
            if (!(time[row] > time[row - 1]))
                refuse(row, time_column_,
                       fmt::format("time {:.9g} s does not rise above {:.9g} s", time[row], time[row - 1]),
                       "sort the rows by time, or cut the record where the clock was set back");
        if (!problems_.empty())
            return;
        const double step = record_.step();
        std::size_t worst = 1, gaps = 0;
        for (std::size_t row = 1; row < time.size(); ++row) {
            if (std::abs(time[row] - time[row - 1] - step) > std::abs(time[worst] - time[worst - 1] - step))
                worst = row;
            gaps += time[row] - time[row - 1] > 1.5 * step ? 1 : 0;
        }
        const double off = std::abs(time[worst] - time[worst - 1] - step);
        if (gaps > 0)
            warn(worst, time_column_,
                 fmt::format("{} gap{} in time, the longest of {}", gaps, gaps == 1 ? "" : "s",
                             format_si(time[worst] - time[worst - 1], "s", 3)),
                 "harmless while the times are true; first guesses of frequencies suffer");
        else if (off > uneven * step)
            warn(worst, time_column_,
                 fmt::format("uneven sampling: a step of {}, the usual one is {}",
                             format_si(time[worst] - time[worst - 1], "s", 4), format_si(step, "s", 4)),
                 "the fit uses the times as written: see that they are those of the samples");
    }

    void check_channels() {
        for (std::size_t k = 0; k < record_.channels.size(); ++k) {
            for (std::size_t other = 0; other < k; ++other)
                if (record_.channels[k].values == record_.channels[other].values)
                    refuse(0, columns_[k],
                           fmt::format("column {} is equal to column {} in every row", table_.heads()[columns_[k]],
                                       table_.heads()[columns_[other]]),
                           "export the record again, each axis in its own column");
            if (record_.channels[k].values == record_.time)
                refuse(0, columns_[k], fmt::format("column {} holds the time", table_.heads()[columns_[k]]),
                       "export the record again, the acceleration in this column");
            check_levels(record_.channels[k], columns_[k]);
        }
        check_units();
    }

    void check_levels(const Channel& channel, std::size_t column) {
        const std::size_t levels = distinct_levels(channel.values, few_levels);
        if (levels == 1) {
            warn(0, column, fmt::format("{} never changes: a dead channel", channel.name),
                 "check cable and range; it is fitted as zero motion");
            return;
        }
        if (levels <= few_levels)
            warn(0, column, fmt::format("{} takes {} different values: coarsely quantised", channel.name, levels),
                 "choose a smaller range or more bits; small lines may be the converter's own");
        const Stretch flat = longest_at_extreme(channel.values);
        if (flat.length >= clipped_run)
            warn(flat.first, column,
                 fmt::format("{} stays at its extreme {} m/s2 for {} samples: clipped", channel.name,
                             shortest(channel.values[flat.first]), flat.length),
                 "choose a larger range; clipping lowers the line and adds odd orders that are not there");
    }

    /// A sensor that sees gravity shows its own unit: 1 in g, 9.8 in m/s2.
    void check_units() {
        double square = 0;
        for (const Channel& channel : record_.channels) {
            double sum = 0;
            for (const double value : channel.values)
                sum += value;
            square += std::pow(sum / static_cast<double>(channel.values.size()), 2);
        }
        const double mean = std::sqrt(square);
        const std::string& head = table_.heads()[columns_.front()];
        if (head.ends_with("_m_s2") && std::abs(mean - 1) < 0.05)
            warn(0, columns_.front(), "the mean acceleration is 1.0 m/s2: gravity, if the numbers are in g",
                 "if they are, call the columns ax_g, ay_g, az_g");
        if (head.ends_with("_g") && std::abs(mean / standard_gravity - standard_gravity) < 0.5)
            warn(0, columns_.front(), "the mean acceleration is 9.8 g: gravity, if the numbers are in m/s2",
                 "if they are, call the columns ax_m_s2, ay_m_s2, az_m_s2");
    }

    const Table& table_;
    Record record_;
    std::size_t time_column_ = 0;
    std::vector<std::size_t> columns_; // parallel to record_.channels
    Problems problems_;
};

} // namespace

double Record::step() const {
    std::vector<double> steps;
    for (std::size_t k = 1; k < time.size(); ++k)
        steps.push_back(time[k] - time[k - 1]);
    return median(std::move(steps));
}

Result<Record> parse_record(std::string text, const std::string& source) {
    const Result<Table> table = parse_table(std::move(text), source);
    if (!table)
        return table.problems();
    return Reader(*table).read();
}

Result<Record> read_record(const std::filesystem::path& file) {
    Result<std::string> text = scene::read_file(file, TableLimits{}.bytes);
    return text ? parse_record(std::move(*text), file.string()) : text.problems();
}

Result<Record> together(Record first, const Record& second) {
    const bool same = first.time.size() == second.time.size() &&
                      std::equal(first.time.begin(), first.time.end(), second.time.begin(),
                                 [&](double a, double b) { return std::abs(a - b) <= 1e-3 * first.step(); });
    if (!same)
        return Problem{.file = second.file,
                       .what = fmt::format("its times are not those of {}", first.file),
                       .fix = "phases can be compared only when one instrument sampled both sensors at the same "
                              "instants; export both with one time column"};
    for (Channel channel : second.channels) {
        channel.sensor = 1;
        channel.name += "2";
        first.channels.push_back(std::move(channel));
    }
    first.warnings.insert(first.warnings.end(), second.warnings.begin(), second.warnings.end());
    return first;
}

} // namespace tumble::excitation
