#include "diagnose/read_bulk.h"

#include "base/text.h"
#include "diagnose/bed_number.h"
#include "diagnose/measure_units.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace tumble::diagnose {

namespace {

std::string names_of(const std::vector<Unit>& units) {
    std::vector<std::string> names;
    for (const Unit& unit : units)
        names.push_back(fmt::format("unit = \"{}\"", unit.name));
    return fmt::format("{}", fmt::join(names, " or "));
}

class BulkReader {
public:
    BulkReader(const scene::KeyTable& number, scene::Report& report) : number_keys_(number), report_(report) {}

    std::optional<Bulk> read(const TypedTable& table) {
        const scene::View& view = table.view;
        Bulk bulk;
        bulk.condition = view.text("name");
        bulk.sets = view.words("set");
        bulk.held_out = view.flag("held_out");
        bulk.runs = static_cast<int>(view.integer("runs"));
        if (view.given("from_s"))
            bulk.from = view.number("from_s");
        if (view.given("until_s"))
            bulk.until = view.number("until_s");
        if (bulk.from && bulk.until && *bulk.from >= *bulk.until)
            report_.add(view.place("until_s"), "bulk.until_s",
                        fmt::format("averaging ends at {:g} s, before it begins at {:g} s", *bulk.until, *bulk.from),
                        "let until_s be later than from_s");
        if (!conditions_.insert(bulk.condition).second)
            report_.add(view.place("name"), "bulk.name", fmt::format("there are two [[bulk]] '{}'", bulk.condition),
                        "give each condition its own name, and the mean of runs that repeat each other once, with how "
                        "many they were (runs)");
        for (const TypedTable& inner : tables_of(*table.node, "number", number_keys_, report_))
            number(inner.view, bulk);
        if (bulk.numbers.empty())
            return std::nullopt;
        return bulk;
    }

private:
    void number(const scene::View& view, Bulk& bulk) {
        if (!view.given("measure") || !view.given("value"))
            return;
        const BedNumberName name{view.text("take"), view.text("measure")};
        const std::string measure = name.joined();
        const auto si = name.measure == "time"
                            ? Result<std::string>(Problem{.what = "time is no measure of a bed", .fix = "leave it out"})
                            : unit_of_number(name);
        if (!si)
            return report_.add(view.place("measure"), "bulk.number.measure", si.problems()[0].what,
                               si.problems()[0].fix);
        const auto unit = unit_in(view, measure, units_for(*si));
        if (!unit)
            return;
        if (!view.written("sigma") && bulk.runs == 1)
            return report_.add(view.place("value"), "bulk.number.sigma",
                               fmt::format("{} has no sigma, and one run shows none", measure),
                               "give sigma, the standard deviation between runs (parts of one long run will do), or "
                               "measure more runs and give their number (runs)");
        if (std::any_of(bulk.numbers.begin(), bulk.numbers.end(),
                        [&](const BulkNumber& other) { return other.measure == measure; }))
            return report_.add(view.place("measure"), "bulk.number.measure",
                               fmt::format("{} stands twice in '{}'", measure, bulk.condition),
                               "give the mean of what repeats each other once, with the number of runs");
        bulk.numbers.push_back(
            {measure, *si, view.number("value") * unit->si, view.given("sigma") ? view.number("sigma") * unit->si : 0});
    }

    /// The unit written, where the measure can have it.
    std::optional<Unit> unit_in(const scene::View& view, const std::string& measure, const std::vector<Unit>& units) {
        const std::string written = view.text("unit");
        for (const Unit& unit : units)
            if (unit.name == written)
                return unit;
        if (units[0].name.empty())
            report_.add(view.place("unit"), "bulk.number.unit", measure + " is a plain number", "leave unit out");
        else if (!view.written("unit"))
            report_.add(view.place("value"), "bulk.number.unit", fmt::format("{} has no unit here", measure),
                        "add " + names_of(units));
        else
            report_.add(view.place("unit"), "bulk.number.unit",
                        fmt::format("'{}' is no unit of {}", excerpt(written), measure), "write " + names_of(units));
        return std::nullopt;
    }

    const scene::KeyTable& number_keys_;
    scene::Report& report_;
    std::set<std::string> conditions_;
};

} // namespace

std::vector<Bulk> read_bulks(const scene::Node& root, const scene::KeyTable& bulk, const scene::KeyTable& number,
                             scene::Report& report) {
    const TypedTables tables = tables_of(root, "bulk", bulk, report);
    BulkReader reader(number, report);
    std::vector<Bulk> bulks;
    std::size_t fitted = 0;
    for (const TypedTable& table : tables)
        if (auto one = reader.read(table)) {
            fitted += one->held_out ? 0 : one->numbers.size();
            bulks.push_back(std::move(*one));
        }
    if (report.clean() && !tables.empty() && fitted < 2)
        report.add(tables[0].node->place, "bulk",
                   fmt::format("{} to learn from: nothing can be diagnosed from {}",
                               fitted == 0 ? "every bed is held out, so there is no number" : "there is one number",
                               fitted == 0 ? "none" : "it, for every cause could explain it"),
                   fitted == 0 ? "hold out fewer"
                               : "measure a second number of the bed, or it under a second condition");
    return bulks;
}

void doubt_bulk(const Bulk& bulk, const std::filesystem::path& file, Problems& warnings) {
    for (const BulkNumber& number : bulk.numbers)
        if (number.sigma == 0)
            warnings.push_back({.file = file.string(),
                                .key = "sigma missing",
                                .what = fmt::format("{}: the scatter of {} between runs is not stated", bulk.condition,
                                                    number.measure),
                                .fix = "give sigma; that of the simulation is used instead"});
}

} // namespace tumble::diagnose
