#include "diagnose/response_table.h"

#include "base/table.h"
#include "base/text.h"
#include "observe/whole_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr std::array first_heads{"run", "condition", "cause", "amplitude", "seed", "from_s", "until_s", "wall_s"};
constexpr const char* scene_head = "scene"; // the next one; tables of old lack it
constexpr const char* what_it_is =
    "# Response table of `tumble diagnose`: means of a bed's runs, a line each. docs/diagnosis.md, \"Beds\".\n";

std::string cell_of(double value) {
    return std::isnan(value) ? "nan" : shortest(value);
}

bool called_alike(const BedRun& a, const BedRun& b) {
    return a.condition == b.condition && a.cause == b.cause && a.amplitude == b.amplitude && a.seed == b.seed;
}

} // namespace

Result<ResponseTable> ResponseTable::open(const std::filesystem::path& file, std::vector<std::string> columns) {
    ResponseTable table;
    table.file_ = file;
    table.columns_ = std::move(columns);
    table.required_ = table.columns_.size();
    if (std::filesystem::exists(file))
        if (const auto read = table.read(); !read)
            return read.problems();
    return table;
}

Result<Done> ResponseTable::read() {
    auto text = observe::read_whole(file_);
    if (!text)
        return text.problems();
    const auto cells = parse_table(std::move(*text), file_.string());
    if (!cells)
        return cells.problems();
    const auto& heads = cells->heads();
    if (heads.size() < first_heads.size() || !std::equal(first_heads.begin(), first_heads.end(), heads.begin()))
        return Problem{.file = file_.string(),
                       .what = "this is no response table",
                       .fix = "name another file for it (--table), or remove this one"};
    const bool dated = heads.size() > first_heads.size() && heads[first_heads.size()] == scene_head;
    const std::size_t first_mean = first_heads.size() + (dated ? 1 : 0);
    for (std::size_t c = first_mean; c < heads.size(); ++c)
        if (std::find(columns_.begin(), columns_.end(), heads[c]) == columns_.end())
            columns_.push_back(heads[c]);
    for (std::size_t row = 0; row < cells->rows(); ++row) {
        const auto text_at = [&](std::size_t column) { return std::string(cells->cell(row, column)); };
        const auto number_at = [&](std::size_t column) {
            const auto number = parse_number(cells->cell(row, column));
            return number ? *number : std::nan("");
        };
        BedRun run{.run = text_at(0),
                   .condition = text_at(1),
                   .cause = text_at(2),
                   .amplitude = text_at(3),
                   .seed = static_cast<std::uint64_t>(
                       parse_integer(cells->cell(row, 4)).ok() ? *parse_integer(cells->cell(row, 4)) : 0),
                   .from = number_at(5),
                   .until = number_at(6),
                   .wall = number_at(7),
                   .scene = dated ? text_at(first_heads.size()) : "",
                   .means = {}};
        for (std::size_t c = first_mean; c < heads.size(); ++c)
            if (!cells->cell(row, c).empty())
                run.means[heads[c]] = number_at(c);
        runs_.push_back(std::move(run));
    }
    return Done{};
}

bool ResponseTable::whole(const BedRun& run) const {
    return std::all_of(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(required_),
                       [&](const std::string& column) { return run.means.contains(column); });
}

const BedRun* ResponseTable::find(const std::string& run) const {
    for (const BedRun& one : runs_)
        if (one.run == run && whole(one))
            return &one;
    return nullptr;
}

const BedRun* ResponseTable::find(const BedRun& like) const {
    for (const BedRun& one : runs_)
        if (called_alike(one, like) && one.scene == like.scene && whole(one))
            return &one;
    return nullptr;
}

bool ResponseTable::has_of_another_scene(const BedRun& like) const {
    return std::any_of(runs_.begin(), runs_.end(),
                       [&](const BedRun& one) { return called_alike(one, like) && one.scene != like.scene; });
}

Result<Done> ResponseTable::add(BedRun run) {
    std::erase_if(runs_, [&](const BedRun& old) { return old.run == run.run; }); // one that lacked a column
    runs_.push_back(std::move(run));
    if (file_.empty())
        return Done{};
    std::vector<std::string> cells(first_heads.begin(), first_heads.end());
    cells.emplace_back(scene_head);
    cells.insert(cells.end(), columns_.begin(), columns_.end());
    std::string text = what_it_is + csv_line(cells);
    for (const BedRun& one : runs_) {
        cells = {one.run,           one.condition,      one.cause,          one.amplitude, std::to_string(one.seed),
                 cell_of(one.from), cell_of(one.until), fixed(one.wall, 1), one.scene};
        for (const std::string& column : columns_) {
            const auto found = one.means.find(column);
            cells.push_back(found == one.means.end() ? "" : cell_of(found->second));
        }
        text += csv_line(cells);
    }
    return observe::write_whole(file_, text);
}

} // namespace tumble::diagnose
