#include "sheet/show.h"

#include <fmt/format.h>

namespace tumble::sheet {

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '_' || c == '*' || c == '|' || c == '<')
            safe += '\\';
        safe += c;
    }
    return safe;
}

std::string prose(const std::string& text) {
    std::string safe, piece;
    bool code = false;
    for (const char c : text + "`") {
        if (c != '`') {
            piece += c;
            continue;
        }
        safe += (code ? piece : escaped(piece)) + "`";
        piece.clear();
        code = !code;
    }
    safe.pop_back();
    return safe;
}

namespace {

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells)
        line += " " + escaped(cell) + " |";
    return line + "\n";
}

struct PageWriter {
    std::string folder;

    std::string operator()(const Heading& heading) const { return "## " + escaped(heading.text) + "\n"; }
    std::string operator()(const Paragraph& paragraph) const { return wrapped(prose(paragraph.text), 120); }
    std::string operator()(const Formula& formula) const {
        return "    " + formula.text + (formula.source.empty() ? "" : "        " + formula.source) + "\n";
    }
    std::string operator()(const Grid& grid) const {
        std::vector<std::string> heads;
        std::string text = "|";
        for (const Column& column : grid.columns) {
            heads.push_back(head_of(column));
            text += " --- |";
        }
        text = row(heads) + text + "\n";
        for (const auto& cells : cells_of(grid))
            text += row(cells);
        return text;
    }
    std::string operator()(const Figure& figure) const {
        return fmt::format("![{}]({}/{}.svg)\n", figure.title, folder, figure.name);
    }
    std::string operator()(const Picture& picture) const {
        return fmt::format("![{0}]({1}/{2}.png)\n\n", picture.title, folder, picture.name) +
               wrapped(prose(picture.title + "; " + picture.note + "."), 120);
    }
};

} // namespace

std::string to_page(const Part& part, const std::string& folder) {
    return std::visit(PageWriter{folder}, part);
}

std::string to_page(const Sheet& sheet, const std::string& folder) {
    std::string page;
    for (const Part& part : sheet.parts)
        page += "\n" + to_page(part, folder);
    return page;
}

} // namespace tumble::sheet
