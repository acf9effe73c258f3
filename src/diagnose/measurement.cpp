#include "diagnose/measurement.h"

#include "base/hash.h"
#include "base/table.h"
#include "base/text.h"
#include "diagnose/cause.h"
#include "diagnose/considered.h"
#include "diagnose/data_doubts.h"
#include "diagnose/measure_units.h"
#include "diagnose/read_bulk.h"
#include "diagnose/read_table.h"
#include "diagnose/typed_tables.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace tumble::diagnose {

namespace {

constexpr std::size_t largest_measurement = std::size_t{1} << 20; // bytes
constexpr std::size_t fewest_in_series = 8;                       // of a series
constexpr std::size_t largest_data = std::size_t{64} << 20;       // bytes

class Reader {
public:
    Reader(const std::filesystem::path& file, const scene::Node& root) : root_(root) {
        read_.file = file;
        for (const scene::KeyTable& table : measurement_keys())
            keys_.push_back(&table);
    }

    Result<Measurement> read(const std::string& text) {
        check_tables(root_, measurement_keys(), report_);
        hash_.add(text);
        top();
        const TypedTables nuisances = tables_of(root_, "nuisance", *keys_[1], report_);
        for (const TypedTable& table : nuisances)
            nuisance(table.view);
        for (const TypedTable& table : tables_of(root_, "series", *keys_[2], report_))
            series(table);
        for (const TypedTable& one : tables_of(root_, "table", *keys_[6], report_))
            table(one);
        read_.bulks = read_bulks(root_, *keys_[4], *keys_[5], report_);
        check_kinds();
        for (const TypedTable& table : nuisances)
            if (read_.bulks.empty())
                check_nuisance_of_records(table.view);
            else
                check_nuisance_of_bed(table.view);
        check_sensors(nuisances);
        for (const Record& record : read_.records)
            doubt_record(record, read_.warnings);
        for (const Bulk& bulk : read_.bulks)
            doubt_bulk(bulk, read_.file, read_.warnings);
        for (const Problems& wrong : {equal_columns(read_.records), lost_readings(read_.records)})
            for (const Problem& problem : wrong)
                report_.add(Problems{problem});
        if (!report_.clean())
            return report_.sorted(read_.file.string());
        read_.hash = hash_.hex();
        return read_;
    }

private:
    void top() {
        const scene::View view(&root_, *keys_[0], "", report_);
        read_.title = view.text("title");
        read_.causes = view.words("causes");
        read_.settings.alpha_gate = view.number("alpha_gate");
        read_.settings.alpha_adequacy = view.number("alpha_adequacy");
        read_.settings.margin = view.number("margin_nats");
        const bool beds = !tables_of(root_, "bulk", *keys_[4], report_).empty();
        if (const auto chosen = choose_causes(read_.causes, beds ? Data::beds : Data::records); !chosen)
            for (const Problem& problem : chosen.problems())
                report_.add(view.place("causes"), "causes", problem.what, problem.fix);
    }

    /// Records or numbers of beds, not both and not neither.
    void check_kinds() {
        const TypedTables bulks = tables_of(root_, "bulk", *keys_[4], report_);
        const bool series = !tables_of(root_, "series", *keys_[2], report_).empty() ||
                            !tables_of(root_, "table", *keys_[6], report_).empty();
        if (bulks.empty() && !series)
            return report_.add(root_.place, "series", "the measurement has neither [[series]], [[table]] nor [[bulk]]",
                               "add [[series]] for what was read over time, [[table]] for single numbers such as "
                               "heights of rebounds, or [[bulk]] for means of a bed");
        if (bulks.empty())
            return;
        if (series)
            report_.add(bulks[0].node->place, "bulk", "the measurement has [[bulk]] beside [[series]] or [[table]]",
                        "make two measurements of them: a path of one body is compared as it is, of a bed only means");
    }

    void check_nuisance_of_records(const scene::View& view) {
        for (const char* word : {"measure", "cause"})
            if (view.given(word))
                report_.add(view.place(word), std::string("nuisance.") + word,
                            fmt::format("'{}' is a nuisance of beds", word),
                            "of records write key, a number of the scene, or instrument");
    }

    void check_nuisance_of_bed(const scene::View& view) {
        for (const char* word : {"key", "instrument"})
            if (view.given(word))
                report_.add(view.place(word), std::string("nuisance.") + word,
                            fmt::format("'{}' is a nuisance of records", word),
                            "of a bed write measure, a number whose zero is not well known, or cause, one of the "
                            "library that is innocent here, such as fric.factor");
        const std::string measure = view.text("measure"), cause = view.text("cause");
        const auto is_it = [&](const BulkNumber& number) { return number.measure == measure; };
        if (view.given("measure") && std::none_of(read_.bulks.begin(), read_.bulks.end(), [&](const Bulk& bulk) {
                return std::any_of(bulk.numbers.begin(), bulk.numbers.end(), is_it);
            }))
            report_.add(view.place("measure"), "nuisance.measure",
                        fmt::format("no [[bulk.number]] is of '{}'", excerpt(measure)),
                        "write the measure of a number that is given");
        if (!view.given("cause"))
            return;
        const auto chosen = choose_causes({cause}, Data::beds);
        if (!chosen)
            report_.add(view.place("cause"), "nuisance.cause", chosen.problems()[0].what, chosen.problems()[0].fix);
        else if (chosen->front().id != cause)
            report_.add(view.place("cause"), "nuisance.cause", fmt::format("'{}' is a family of causes", cause),
                        fmt::format("name one of it, such as {}", chosen->front().id));
        else if (view.text("per") == "series")
            report_.add(view.place("per"), "nuisance.per", "a cause acts under all conditions alike", "leave per out");
    }

    /// All columns name their sensor, or none does; a nuisance is of one that is there.
    void check_sensors(const TypedTables& nuisances) {
        std::set<std::string> sensors = sensors_of(read_.records);
        if (sensors.size() > 1 && sensors.erase("") > 0)
            report_.add(root_.place, "series.column.sensor",
                        fmt::format("some columns name their sensor ({}), and some do not", fmt::join(sensors, ", ")),
                        "write sensor in every column, or in none where one instrument read them all");
        for (const TypedTable& one : nuisances) {
            if (!one.view.given("sensor"))
                continue;
            if (!one.view.given("instrument"))
                report_.add(one.view.place("sensor"), "nuisance.sensor", "only a part of the instrument has a sensor",
                            "leave sensor out, or write instrument");
            else if (!sensors.contains(one.view.text("sensor")))
                report_.add(one.view.place("sensor"), "nuisance.sensor",
                            fmt::format("no column is of the sensor '{}'", excerpt(one.view.text("sensor"))),
                            sensors.contains("") ? "write sensor in the columns too, or leave it out"
                                                 : fmt::format("write one of {}", fmt::join(sensors, ", ")));
        }
    }

    void nuisance(const scene::View& view) {
        read_.nuisances.push_back({.key = view.text("key"),
                                   .instrument = view.text("instrument"),
                                   .per_record = view.text("per") == "series",
                                   .spread = view.given("spread") ? view.number("spread") : 0,
                                   .measure = view.text("measure"),
                                   .cause = view.text("cause"),
                                   .sensor = view.text("sensor"),
                                   .place = view.place("key")});
    }

    void series(const TypedTable& table) {
        Record record;
        record.name = table.view.text("name");
        if (!series_.insert(record.name).second)
            return report_.add(
                table.view.place("name"), "series.name", fmt::format("there are two [[series]] '{}'", record.name),
                fmt::format("give each its own name; of repeats the same condition, condition = \"{}\"", record.name));
        record.sets = table.view.words("set");
        record.held_out = table.view.flag("held_out");
        record.condition = table.view.given("condition") ? table.view.text("condition") : condition_of(record);
        const auto cells = cells_of(table.view, "series.file");
        if (!cells)
            return;
        record.file = cells->file();
        if (cells->rows() < fewest_in_series)
            return report_.add(
                Problems{{.file = cells->file(),
                          .what = fmt::format("{} readings are too few for a series over time", cells->rows()),
                          .fix = fmt::format("give {} or more", fewest_in_series)}});
        const auto& heads = cells->heads();
        const auto has = [&](const char* head) { return std::find(heads.begin(), heads.end(), head) != heads.end(); };
        const std::string clock = !has("time_s") && !has("time_ms") && (has("t_s") || has("t_ms")) ? "t" : "time";
        auto time = cells->quantity(clock, units_for("s"));
        if (!time)
            return report_.add(time.problems());
        record.time = std::move(*time);
        check_time(*cells, clock, record.time);
        for (const TypedTable& column : tables_of(*table.node, "column", *keys_[3], report_))
            if (auto channel = channel_of(column.view, *cells, "series.column", report_))
                record.channels.push_back(std::move(*channel));
        if (!record.channels.empty())
            read_.records.push_back(std::move(record));
    }

    /// A number of the scene is a nuisance of every series: equal sets do not make equal conditions.
    [[nodiscard]] bool adjusted_in_each() const {
        return std::any_of(read_.nuisances.begin(), read_.nuisances.end(),
                           [](const Nuisance& nuisance) { return nuisance.per_record && !nuisance.key.empty(); });
    }

    /// That of the first series with the same sets.
    [[nodiscard]] std::string condition_of(const Record& record) const {
        const auto like = std::find_if(read_.records.begin(), read_.records.end(), [&](const Record& one) {
            return !one.single() && one.sets == record.sets && one.held_out == record.held_out;
        });
        return adjusted_in_each() || like == read_.records.end() ? record.name : like->condition;
    }

    void check_time(const Table& cells, const std::string& clock, const std::vector<double>& time) {
        const Result<std::size_t> seconds = cells.find(clock + "_s");
        const std::size_t column = seconds ? *seconds : *cells.find(clock + "_ms");
        for (std::size_t k = 1; k < time.size(); ++k)
            if (time[k] <= time[k - 1])
                return report_.add(Problems{cells.problem_at(
                    k, column,
                    fmt::format("time does not rise: {} after {}", cells.cell(k, column), cells.cell(k - 1, column)),
                    "sort the rows by time and leave one of each instant")});
    }

    void table(const TypedTable& table) {
        if (!tables_.insert(table.view.text("name")).second)
            return report_.add(table.view.place("name"), "table.name",
                               fmt::format("there are two [[table]] '{}'", table.view.text("name")),
                               "give each its own name: conditions are called by it");
        if (const auto cells = cells_of(table.view, "table.file"))
            for (Record& record : records_of_table(table, *cells, *keys_[7], report_, read_.warnings))
                read_.records.push_back(std::move(record));
    }

    /// The cells of the CSV file that a table names.
    std::optional<Table> cells_of(const scene::View& view, const std::string& key) {
        if (!view.given("file"))
            return std::nullopt;
        const std::filesystem::path file = read_.file.parent_path() / view.text("file");
        auto text = scene::read_file(file, largest_data);
        if (!text) {
            report_.add(view.place("file"), key, fmt::format("{} {}", file.string(), text.problems()[0].what),
                        "give the CSV file's name as seen from this file's folder");
            return std::nullopt;
        }
        hash_.add(*text);
        auto cells = parse_table(std::move(*text), file.string());
        if (!cells) {
            report_.add(cells.problems());
            return std::nullopt;
        }
        return std::move(*cells);
    }

    const scene::Node& root_;
    std::vector<const scene::KeyTable*> keys_;
    scene::Report report_;
    Measurement read_;
    Hash64 hash_;
    std::set<std::string> series_, tables_; // names
};

} // namespace

Result<Measurement> load_measurement(const std::filesystem::path& file) {
    const auto text = scene::read_file(file, largest_measurement);
    if (!text)
        return text.problems();
    const auto root = scene::parse_toml(*text, file.string());
    if (!root)
        return root.problems();
    return Reader(file, *root).read(*text);
}

} // namespace tumble::diagnose
