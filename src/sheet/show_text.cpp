#include "base/text.h"
#include "sheet/show.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::sheet {

namespace {

std::string with_unit(const std::string& word, const std::string& unit) {
    return unit.empty() ? word : word + ", " + unit;
}

std::string padded(const std::string& text, std::size_t to) {
    return text + std::string(to - std::min(to, letters(text)), ' ');
}

std::string shown(const Cell& cell, const Column& column) {
    const auto* number = std::get_if<double>(&cell);
    if (!number)
        return std::get<std::string>(cell);
    const bool rounding = std::abs(*number) < 1e-12 * column.of;
    return fmt::format("{:.{}g}", rounding ? 0.0 : *number + 0.0, column.digits);
}

std::string text_of(const Heading& heading) {
    return heading.text + "\n" + std::string(letters(heading.text), '-') + "\n";
}

std::string text_of(const Paragraph& paragraph) {
    return wrapped(paragraph.text, text_width);
}

std::string text_of(const Formula& formula) {
    const std::string line = "    " + formula.text;
    if (formula.source.empty())
        return line + "\n";
    const std::size_t room = text_width - std::min(text_width - 2, letters(formula.source));
    return padded(line, std::max(letters(line) + 2, room)) + formula.source + "\n";
}

std::string text_of(const Grid& grid) {
    std::vector<std::vector<std::string>> rows = cells_of(grid);
    rows.insert(rows.begin(), std::vector<std::string>{});
    for (const Column& column : grid.columns)
        rows.front().push_back(head_of(column));
    std::vector<std::size_t> widths(grid.columns.size(), 0);
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k)
            widths[k] = std::max(widths[k], letters(row[k]));
    std::string text;
    for (const auto& row : rows) {
        std::string line = "  ";
        for (std::size_t k = 0; k < row.size(); ++k)
            line += padded(row[k], widths[k] + 2);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string text_of(const Figure& figure) {
    std::string curves;
    for (const Curve& curve : figure.curves)
        if (!curve.label.empty()) // points beside a labelled line share its name
            curves += (curves.empty() ? "" : "; ") + curve.label;
    return wrapped(fmt::format("[figure {}: {}; {} over {}; {}]", figure.name, figure.title, figure.y.label,
                               figure.x.label, curves),
                   text_width);
}

std::string text_of(const Picture& picture) {
    return wrapped(fmt::format("[picture {}: {}; {}]", picture.name, picture.title, picture.note), text_width);
}

} // namespace

std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
    std::string all, line = indent;
    for (const std::string_view piece : split_words(text)) {
        const std::string word(piece);
        if (line.size() > indent.size() && letters(line) + 1 + letters(word) > width) {
            all += line + "\n";
            line = indent;
        }
        line += (line.size() > indent.size() ? " " : "") + word;
    }
    return all + line + "\n";
}

std::string head_of(const Column& column) {
    return with_unit(column.head, column.unit);
}

std::vector<std::vector<std::string>> cells_of(const Grid& grid) {
    std::vector<std::vector<std::string>> rows;
    for (const std::vector<Cell>& cells : grid.rows) {
        rows.emplace_back();
        for (std::size_t k = 0; k < cells.size(); ++k)
            rows.back().push_back(shown(cells[k], grid.columns[k]));
    }
    return rows;
}

std::string to_text(const std::string& title, const Sheet& sheet) {
    std::string text = title + "\n" + std::string(letters(title), '=') + "\n";
    for (const Part& part : sheet.parts)
        text += "\n" + std::visit([](const auto& one) { return text_of(one); }, part);
    return text;
}

} // namespace tumble::sheet
