#include "lesson/show.h"

#include <fmt/format.h>

namespace tumble::lesson {

using sheet::escaped;
using sheet::prose;
using sheet::text_width;
using sheet::wrapped;

namespace {

/// " --e 0.5" for each value that is not the usual one.
std::string flags_for(const Lesson& lesson, const Values& values) {
    std::string flags;
    for (const Parameter& parameter : lesson.parameters)
        if (values[parameter.name] != parameter.standard)
            flags += fmt::format(" --{} {}", parameter.name, scene::plain(values[parameter.name]));
    return flags;
}

} // namespace

std::string to_text(const Lesson& lesson, const Values& values, const Walk& walk) {
    sheet::Sheet all = walk;
    all.parts.insert(all.parts.begin(), sheet::grid_of(lesson.parameters, values));
    return sheet::to_text(lesson.title, all) + "\n" + wrapped("Question: " + walk.question, text_width) +
           wrapped(fmt::format("(`tumble lesson {}{} --answer` computes it once more and tells the answer.)",
                               lesson.name, flags_for(lesson, values)),
                   text_width);
}

std::string to_page(const Lesson& lesson, const Values& values, const Walk& walk) {
    Grid with{{{"parameter"}, {"value"}, {"unit"}, {"range"}, {"what it is"}}, {}};
    for (const Parameter& parameter : lesson.parameters)
        with.rows.push_back({parameter.name, values[parameter.name], parameter.unit, scene::describe(parameter.limits),
                             parameter.sentence});
    std::string page = fmt::format(
        "# {}\n\nMade by `tumble lesson --pages docs/lessons`; the walk is what `tumble lesson {}` prints.\n\n",
        escaped(lesson.title), lesson.name);
    page += sheet::to_page(with, "") + sheet::to_page(walk, lesson.name);
    page += "\n## Question\n\n" + wrapped(prose(walk.question), 120);
    return page + "\n<details><summary>Answer</summary>\n\n" + wrapped(prose(walk.answer), 120) + "\n</details>\n";
}

std::string contents_page() {
    std::string page =
        "# Lessons\n\n"
        "Fundamentals of the discrete element method, step by step; numbers in round brackets are the thesis' "
        "equations. "
        "Every number\n"
        "is computed when the page is made, by the solvers themselves (`tumble lesson --pages docs/lessons`).\n\n"
        "`tumble lesson NAME` prints one, `--help` lists the numbers that can be changed in it, `--out DIR` draws its "
        "figures\n"
        "and videos, `--answer` tells the answer to the question at its end.\n\n"
        "| lesson | title |\n"
        "| --- | --- |\n";
    for (const Lesson& lesson : all_lessons())
        page += fmt::format("| [{0}]({0}.md) | {1} |\n", lesson.name, escaped(lesson.title));
    return page;
}

nlohmann::ordered_json to_json(const Lesson& lesson, const Values& values, const Walk& walk) {
    nlohmann::ordered_json json{{"lesson", lesson.name}, {"title", lesson.title}, {"parameters", values.all()}};
    json.update(sheet::to_json(walk));
    json["question"] = walk.question;
    json["answer"] = walk.answer;
    return json;
}

} // namespace tumble::lesson
