#include "lesson/show.h"

#include <fmt/format.h>

namespace tumble::lesson {

namespace {

/// Names like k_n and signs like * are meant as they stand.
std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '_' || c == '*' || c == '|' || c == '<')
            safe += '\\';
        safe += c;
    }
    return safe;
}

/// Escapes what stands outside of `code`.
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
    /// Its poster; the video is made on demand.
    std::string operator()(const Film& film) const {
        return fmt::format("![{0}]({1}/{2}.png)\n\n{0}; `tumble lesson {1} --out DIR` makes the video.\n", film.title,
                           folder, film.name);
    }
};

} // namespace

std::string to_page(const Lesson& lesson, const Values& values, const Walk& walk) {
    Grid with{{{"parameter"}, {"value"}, {"unit"}, {"range"}, {"what it is"}}, {}};
    for (const Parameter& parameter : lesson.parameters)
        with.rows.push_back({parameter.name, values[parameter.name], parameter.unit, scene::describe(parameter.limits),
                             parameter.sentence});
    const PageWriter write{lesson.name};
    std::string page = fmt::format(
        "# {}\n\nMade by `tumble lesson --pages docs/lessons`; the walk is what `tumble lesson {}` prints.\n\n",
        escaped(lesson.title), lesson.name);
    page += write(with);
    for (const Part& part : walk.parts)
        page += "\n" + std::visit(write, part);
    page += "\n## Question\n\n" + wrapped(prose(walk.question), 120);
    return page + "\n<details><summary>Answer</summary>\n\n" + wrapped(prose(walk.answer), 120) + "\n</details>\n";
}

std::string contents_page() {
    std::string page =
        "# Lessons\n\nFundamentals of the discrete element method, step by step; numbers in round brackets are the "
        "thesis' equations. Every number\nis computed when the page is made, by the solvers themselves (`tumble lesson "
        "--pages docs/lessons`).\n\n| lesson | title |\n| --- | --- |\n";
    for (const Lesson& lesson : all_lessons())
        page += fmt::format("| [{0}]({0}.md) | {1} |\n", lesson.name, escaped(lesson.title));
    return page + "\nThere is no lesson on rolling resistance: no law for it exists yet.\n";
}

} // namespace tumble::lesson
