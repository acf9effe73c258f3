#include "diagnose/read_table.h"

#include "base/text.h"
#include "diagnose/measure_units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace tumble::diagnose {

namespace {

constexpr std::size_t tells_by_itself = 5; // rows of a condition, for the scatter of its own

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

/// Sum of squares about the mean, and how many numbers are free to scatter.
struct Scatter {
    double squares = 0;
    double free = 0;

    void add(const Scatter& other) {
        squares += other.squares;
        free += other.free;
    }
    [[nodiscard]] double sigma() const { return free > 0 ? std::sqrt(squares / free) : 0; }
};

Scatter scatter_in(const std::vector<double>& values) {
    double mean = 0;
    for (const double value : values)
        mean += value / static_cast<double>(values.size());
    Scatter scatter{.free = static_cast<double>(values.size()) - 1};
    for (const double value : values)
        scatter.squares += (value - mean) * (value - mean);
    return scatter;
}

/// What the rows that repeat each other tell of one column's scatter.
void learn_sigma(std::vector<Record>& records, std::size_t channel, const TypedTable& table, const std::string& file,
                 scene::Report& report, Problems& warnings) {
    std::map<std::string, std::vector<double>> groups;
    for (const Record& record : records)
        groups[record.condition].push_back(record.channels[channel].value[0]);
    std::map<std::string, Scatter> own;
    Scatter pooled;
    for (const auto& [condition, values] : groups) {
        own[condition] = scatter_in(values);
        pooled.add(own[condition]);
    }
    const std::string& head = records[0].channels[channel].head;
    if (pooled.sigma() == 0)
        return report.add(table.view.place(), "table.column.sigma",
                          pooled.free > 0 ? fmt::format("{} has no sigma, and rows that repeat each other do not differ",
                                                        head)
                                          : fmt::format("{} has no sigma, and no two rows repeat each other", head),
                          "give sigma, the scatter of one number, or rows of repeated experiments");
    for (Record& record : records) {
        const Scatter& mine = own[record.condition];
        const bool by_itself = groups[record.condition].size() >= tells_by_itself && mine.squares > 0;
        record.channels[channel].sigma = (by_itself ? mine : pooled).sigma();
    }
    warnings.push_back({.file = file,
                        .key = "sigma from repeats",
                        .what = fmt::format("the scatter of {} is taken from rows that repeat each other, {:.3g} {} "
                                            "with {:g} degrees of freedom",
                                            head, pooled.sigma(), records[0].channels[channel].unit, pooled.free),
                        .fix = "nothing, if they were made as the others were"});
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
            report.add(one.view.place("from_s"), "table.column.from_s",
                       fmt::format("the stretch begins at {:g} s, and the experiment ends at {:g} s", channel->from,
                                   until),
                       "let from_s be earlier than until_s");
        channels.push_back(std::move(*channel));
    }
    std::vector<Record> records;
    if (channels.empty() || !table.view.whole())
        return records;
    std::map<std::string, int> repeats;
    for (std::size_t row = 0; row < cells.rows(); ++row) {
        std::map<std::string, std::string> used;
        Record record;
        record.file = cells.file();
        for (const std::string& set : table.view.words("set")) {
            Problem why;
            auto filled = filled_in(set, cells, row, used, why);
            if (!filled) {
                report.add(table.view.place("set"), "table.set", why.what, why.fix);
                return {};
            }
            record.sets.push_back(std::move(*filled));
        }
        record.condition = condition_named(table.view.text("name"), used);
        record.name = fmt::format("{} ({})", record.condition, ++repeats[record.condition]);
        record.held_out = table.view.flag("held_out");
        record.time = {until};
        for (const Channel& channel : channels) {
            record.channels.push_back(channel);
            record.channels.back().value = {channel.value[row]};
        }
        records.push_back(std::move(record));
    }
    for (std::size_t c = 0; c < channels.size() && report.clean(); ++c)
        if (channels[c].sigma == 0)
            learn_sigma(records, c, table, cells.file(), report, warnings);
    return records;
}

} // namespace tumble::diagnose
