#include "diagnose/read_table.h"

#include "base/column.h"
#include "base/distributions.h"
#include "base/text.h"
#include "diagnose/measure_units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace tumble::diagnose {

namespace {

constexpr double against_sigma = 0.01; // tail probability, below which rows that repeat each other speak against sigma
constexpr double most_beyond = 1.25;   // of sigma stated
constexpr double far_beyond = 20;      // times what rows usually scatter: two slips hide each other in the rest
constexpr std::size_t fewest_beside = 2; // rows that repeat one which is left out: of two nobody knows which it is

/// Text with the row's cells in the places of {HEAD}s; the heads that were used are added to `used`.
std::optional<std::string> filled_in(const std::string& text, const Table& cells, std::size_t row,
                                     std::map<std::string, std::string>& used, Problem& why) {
    std::string all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = text.find('{', at), close = text.find('}', open);
        if (open == std::string::npos || close == std::string::npos)
            return all + text.substr(at);
        const std::string head = text.substr(open + 1, close - open - 1);
        const auto column = cells.find(head);
        if (!column) {
            why = column.problems()[0];
            return std::nullopt;
        }
        used[head] = std::string(cells.cell(row, *column));
        all += text.substr(at, open - at) + used[head];
        at = close + 1;
    }
    return all;
}

std::string condition_named(const std::string& table, const std::map<std::string, std::string>& used) {
    std::vector<std::string> words;
    for (const auto& [head, cell] : used)
        words.push_back(fmt::format("{} {}", head, cell));
    return words.empty() ? table : fmt::format("{}, {}", table, fmt::join(words, ", "));
}

/// Numbers of one column that repeat each other.
struct Group {
    std::vector<double> value{};
    std::vector<std::size_t> row{}; // of the table

    void add(double number, std::size_t of_row) {
        value.push_back(number);
        row.push_back(of_row);
    }
    [[nodiscard]] double count() const { return static_cast<double>(value.size()); }
    [[nodiscard]] Spread spread() const { return spread_of(value); }
    /// Sum of squares about the mean.
    [[nodiscard]] double apart() const { return spread().deviation * spread().deviation * (count() - 1); }
    [[nodiscard]] Group without(std::size_t index) const {
        Group others = *this;
        others.value.erase(others.value.begin() + static_cast<std::ptrdiff_t>(index));
        others.row.erase(others.row.begin() + static_cast<std::ptrdiff_t>(index));
        return others;
    }
};

/// What rows scatter about the medians of those that they repeat, whatever a few of them do: no more than half of the
/// scatter is lost to how few they are.
double usual_scatter(const std::vector<Group>& groups) {
    std::vector<double> apart;
    for (const Group& group : groups)
        for (const double value : group.value)
            if (group.value.size() > fewest_beside)
                apart.push_back(std::abs(value - median(group.value)));
    const double usual = median(apart) / 0.6745;
    return usual > 0 ? usual : INFINITY;
}

/// Leaves out rows that stand out of two or more others that repeat them, as a slip of the pen does: by twenty times
/// what rows usually scatter, or what is stated. Rows that scatter more where the number is larger stay.
void leave_lone_rows_out(std::vector<Group>& groups, const Channel& channel, const Table& cells, Problems& warnings) {
    const double usual = std::max(channel.sigma, usual_scatter(groups));
    for (Group& group : groups)
        for (std::size_t k = 0; k < group.value.size();) {
            const Group others = group.without(k);
            const double away = std::abs(group.value[k] - median(others.value));
            if (others.value.size() < fewest_beside || away < far_beyond * usual) {
                ++k;
                continue;
            }
            const std::size_t column = *cells.find(channel.head);
            warnings.push_back(cells.problem_at(group.row[k], column,
                                                fmt::format("{} stands out of {} rows that repeat it: a slip of the "
                                                            "pen?",
                                                            cells.cell(group.row[k], column), others.value.size()),
                                                "it is left out; correct it if it is one"));
            warnings.back().key = "outliers";
            group = others;
        }
}

/// The scatter of one number of a column: as stated, unless rows that repeat each other contradict it; else as they
/// show it, all conditions together.
void find_sigma(Channel& channel, const std::vector<Group>& groups, const TypedTable& table, const std::string& file,
                scene::Report& report, Problems& warnings) {
    double apart = 0, free = 0;
    for (const Group& group : groups) {
        apart += group.apart();
        free += group.count() - 1;
    }
    const double found = free > 0 ? std::sqrt(apart / free) : 0;
    const auto warn = [&](const char* key, const std::string& what, const char* fix) {
        warnings.push_back({.file = file, .key = key, .what = what, .fix = fix});
    };
    if (channel.sigma > 0) {
        const double chi_square = apart / (channel.sigma * channel.sigma);
        if (free > 0 && chi_square_tail(chi_square, free) < against_sigma && found > most_beyond * channel.sigma) {
            warn("sigma contradicted",
                 fmt::format("rows of {} that repeat each other scatter {:.2f} times as much as stated", channel.head,
                             found / channel.sigma),
                 "the scatter found in them is used");
            channel.sigma = found;
            channel.degrees = free;
        }
        return;
    }
    if (found == 0)
        return report.add(
            table.view.place(), "table.column.sigma",
            free > 0 ? fmt::format("{} has no sigma, and rows that repeat each other do not differ", channel.head)
                     : fmt::format("{} has no sigma, and no two rows repeat each other", channel.head),
            "give sigma, the scatter of one number, or rows of repeated experiments");
    channel.sigma = found;
    channel.degrees = free;
    warn("sigma from repeats",
         fmt::format(
             "the scatter of {} is taken from rows that repeat each other, {:.3g} {} with {:g} degrees of freedom",
             channel.head, found, channel.unit, free),
         "nothing, if they were made as the others were: every test allows for so few");
}

/// The columns of a table as they are asked for, every row's number in them.
std::vector<Channel> columns_of(const TypedTable& table, const Table& cells, const scene::KeyTable& column,
                                scene::Report& report) {
    const double until = table.view.number("until_s");
    std::vector<Channel> channels;
    for (const TypedTable& one : tables_of(*table.node, "column", column, report)) {
        auto channel = channel_of(one.view, cells, "table.column", report);
        if (!channel || !one.view.given("take"))
            continue;
        const auto& words = words_of_takes();
        const auto word = std::find(words.begin(), words.end(), one.view.text("take"));
        channel->take = static_cast<Take>(1 + (word - words.begin()));
        channel->from = one.view.number("from_s");
        if (channel->shows_time())
            report.add(one.view.place("measure"), "table.column.measure", "time is no number of an experiment",
                       "leave it out");
        if (channel->from >= until)
            report.add(
                one.view.place("from_s"), "table.column.from_s",
                fmt::format("the stretch begins at {:g} s, and the experiment ends at {:g} s", channel->from, until),
                "let from_s be earlier than until_s");
        channels.push_back(std::move(*channel));
    }
    return channels;
}

} // namespace

std::optional<Channel> channel_of(const scene::View& view, const Table& cells, const std::string& key,
                                  scene::Report& report) {
    const std::string head = view.text("head"), measure = view.text("measure");
    if (!view.given("head") || !view.given("measure"))
        return std::nullopt;
    const auto unit = unit_of(measure);
    if (!unit) {
        report.add(view.place("measure"), key + ".measure", unit.problems()[0].what, unit.problems()[0].fix);
        return std::nullopt;
    }
    const std::vector<Unit> units = units_for(*unit);
    auto values = cells.quantity(head, units);
    if (!values) {
        report.add(values.problems());
        return std::nullopt;
    }
    Channel channel{.head = head, .measure = measure, .unit = *unit, .value = std::move(*values)};
    channel.sensor = view.text("sensor");
    for (const Unit& one : units)
        if (cells.find(head + "_" + one.name)) {
            channel.head = head + "_" + one.name;
            channel.sigma = view.given("sigma") ? view.number("sigma") * one.si : 0;
            break;
        }
    return channel;
}

std::vector<Record> records_of_table(const TypedTable& table, const Table& cells, const scene::KeyTable& column,
                                     scene::Report& report, Problems& warnings) {
    if (cells.rows() == 0) {
        report.add(Problems{{.file = cells.file(),
                             .what = "there is a head and no row",
                             .fix = "give a row for each time that the experiment ran"}});
        return {};
    }
    std::vector<Channel> channels = columns_of(table, cells, column, report);
    std::vector<Record> records;
    if (channels.empty() || !table.view.whole() || !report.clean())
        return records;
    std::vector<std::vector<Group>> groups(channels.size()); // [channel][record]
    for (std::size_t row = 0; row < cells.rows(); ++row) {
        std::map<std::string, std::string> used;
        std::vector<std::string> sets;
        for (const std::string& set : table.view.words("set")) {
            Problem why;
            auto filled = filled_in(set, cells, row, used, why);
            if (!filled) {
                report.add(table.view.place("set"), "table.set", why.what, why.fix);
                return {};
            }
            sets.push_back(std::move(*filled));
        }
        auto like = std::find_if(records.begin(), records.end(), [&](const Record& one) { return one.sets == sets; });
        if (like == records.end()) {
            Record record;
            record.name = record.condition = condition_named(table.view.text("name"), used);
            record.file = cells.file();
            record.sets = std::move(sets);
            record.held_out = table.view.flag("held_out");
            record.time = {table.view.number("until_s")};
            like = records.insert(records.end(), std::move(record));
            for (std::vector<Group>& of_channel : groups)
                of_channel.emplace_back();
        }
        for (std::size_t c = 0; c < channels.size(); ++c)
            groups[c][static_cast<std::size_t>(like - records.begin())].add(channels[c].value[row], row);
    }
    for (std::size_t c = 0; c < channels.size(); ++c) {
        leave_lone_rows_out(groups[c], channels[c], cells, warnings);
        find_sigma(channels[c], groups[c], table, cells.file(), report, warnings);
    }
    for (std::size_t r = 0; r < records.size(); ++r)
        for (std::size_t c = 0; c < channels.size(); ++c) {
            Channel channel = channels[c];
            channel.rows = static_cast<int>(groups[c][r].value.size());
            channel.value = {groups[c][r].spread().mean};
            channel.sigma /= std::sqrt(channel.rows);
            records[r].channels.push_back(std::move(channel));
        }
    return records;
}

} // namespace tumble::diagnose
