#include "base/text.h"
#include "sheet/show.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tumble::sheet {

namespace {

constexpr std::size_t grid_width = 120;  // letters; grids may be wider than text
constexpr std::size_t narrow_names = 24; // letters in which the first column of a grid that would be wider breaks
constexpr std::size_t gap = 2;           // letters between columns, and before the first

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

using Rows = std::vector<std::vector<std::string>>; // the heads first

std::size_t widest_word(const std::string& text) {
    std::size_t widest = 0;
    for (const std::string_view word : split_words(text))
        widest = std::max(widest, letters(std::string(word)));
    return widest;
}

std::size_t width_of(const std::vector<std::size_t>& widths, const std::vector<std::size_t>& columns) {
    std::size_t width = 0;
    for (const std::size_t k : columns)
        width += gap + widths[k];
    return width;
}

std::vector<std::size_t> widths_of(const Rows& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k)
            widths[k] = std::max(widths[k], letters(row[k]));
    return widths;
}

/// The same with heads, and what rows are called, broken into lines.
std::vector<std::size_t> narrow_widths_of(const Rows& rows) {
    std::vector<std::size_t> widths = widths_of(Rows(rows.begin() + 1, rows.end()));
    std::size_t word = 0;
    for (const auto& row : rows)
        word = std::max(word, widest_word(row.front()));
    widths.front() = std::min(widths.front(), std::max(narrow_names, word));
    for (std::size_t k = 0; k < widths.size(); ++k)
        widths[k] = std::max(widths[k], widest_word(rows.front()[k]));
    return widths;
}

std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
    if (letters(text) <= width)
        return {text};
    const std::string broken = wrapped(text, width);
    std::vector<std::string> lines;
    for (const std::string_view line : split(broken, '\n'))
        lines.emplace_back(line);
    lines.pop_back(); // what follows the last newline
    return lines;
}

std::string text_of(const Rows& rows, const std::vector<std::size_t>& widths, const std::vector<std::size_t>& columns) {
    std::string text;
    for (const auto& row : rows) {
        std::vector<std::vector<std::string>> cells;
        std::size_t height = 0;
        for (const std::size_t k : columns) {
            cells.push_back(lines_of(row[k], widths[k]));
            height = std::max(height, cells.back().size());
        }
        for (std::size_t at = 0; at < height; ++at) {
            std::string line(gap, ' ');
            for (std::size_t k = 0; k < columns.size(); ++k)
                line += padded(at < cells[k].size() ? cells[k][at] : "", widths[columns[k]] + gap);
            line.erase(line.find_last_not_of(' ') + 1);
            text += line + "\n";
        }
    }
    return text;
}

/// A grid that is too wide gets lower heads and, where that is not enough, goes on below, the first column again first.
std::string text_of(const Grid& grid) {
    Rows rows = cells_of(grid);
    rows.insert(rows.begin(), std::vector<std::string>{});
    for (const Column& column : grid.columns)
        rows.front().push_back(head_of(column));
    std::vector<std::size_t> all(grid.columns.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<std::size_t> widths = widths_of(rows);
    if (rows.size() > 1 && width_of(widths, all) > grid_width)
        widths = narrow_widths_of(rows);
    std::string text;
    for (std::size_t next = 0; next < all.size();) {
        std::vector<std::size_t> block{next++};
        if (block.front() > 0)
            block.insert(block.begin(), 0);
        for (; next < all.size() && width_of(widths, block) + gap + widths[next] <= grid_width; ++next)
            block.push_back(next);
        text += (text.empty() ? "" : "\n") + text_of(rows, widths, block);
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
