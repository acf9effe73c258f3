#include "scene/csv.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::scene {
namespace {

constexpr std::size_t most_problems = 20;

std::string without_blanks(std::string_view text) {
    std::string kept;
    for (const char c : text)
        if (c != ' ' && c != '\t')
            kept += c;
    return kept;
}

} // namespace

void Csv::read(std::string_view text, const std::vector<std::string>& heads,
               const std::function<void(const std::vector<Field>&, int line)>& row) {
    Lines lines(text);
    Line line;
    std::size_t columns = 0;
    while (problems_.size() < most_problems && lines.next(line)) {
        const std::string_view content = without_comment(line.text);
        if (trimmed(content).empty())
            continue;
        const auto fields = comma_fields(content);
        if (columns == 0) {
            const std::string head = without_blanks(trimmed(content));
            if (std::find(heads.begin(), heads.end(), head) == heads.end())
                return refuse(line.number, 1,
                              fmt::format("the head is '{}', not '{}'", printable(head), fmt::join(heads, "' or '")));
            columns = fields.size();
        } else if (fields.size() != columns)
            refuse(line.number, 1, fmt::format("{} values below a head of {}", fields.size(), columns));
        else
            row(fields, line.number);
    }
    if (columns == 0)
        refuse(0, 0, "the file is empty");
}

std::optional<double> Csv::number(const Field& field, int line, double limit) {
    const auto value = parse_number(field.text);
    if (!value) {
        refuse(line, field.column, fmt::format("'{}' is not a number", printable(field.text)));
        return std::nullopt;
    }
    if (!(std::abs(*value) <= limit)) {
        refuse(line, field.column, fmt::format("{} is beyond {}", shortest(*value), shortest(limit)));
        return std::nullopt;
    }
    return *value;
}

} // namespace tumble::scene
