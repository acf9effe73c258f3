#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/sheet_flags.h"
#include "lesson/film.h"
#include "lesson/show.h"
#include "observe/whole_file.h"
#include "sheet/plot.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;
using lesson::Lesson;

struct LessonArguments {
    std::string unknown; // a first word that is no lesson
    fs::path pages;
    bool json = false;
};

struct WalkArguments {
    sheet::Typed typed;
    fs::path folder; // for figures; empty: none
    bool json = false;
    bool answer = false;
};

/// The picture that stands for each film.
Result<std::vector<fs::path>> draw_posters(const lesson::Walk& walk, const fs::path& folder) {
    std::vector<fs::path> files;
    for (const lesson::Film& film : walk.films) {
        files.push_back(folder / (film.name + ".png"));
        if (const Result<Done> drawn = lesson::draw_poster(film, files.back()); !drawn)
            return drawn.problems();
    }
    return files;
}

/// Films move only where ffmpeg is; their pictures are there without.
int film_and_note(const lesson::Walk& walk, const fs::path& folder, bool json) {
    const auto posters = draw_posters(walk, folder);
    if (!posters)
        return refuse(posters.problems(), json, failed);
    for (const fs::path& poster : *posters)
        note("figure: " + poster.string());
    for (const lesson::Film& film : walk.films) {
        const fs::path file = folder / (film.name + ".mp4");
        const Result<Done> shot = lesson::shoot(film, file);
        note(shot ? "video: " + file.string() : "no video: " + to_string(shot.problems().front()));
    }
    return fine;
}

int walk_through(const Lesson& lesson, const WalkArguments& arguments) {
    const Result<lesson::Values> values = lesson::read_values(lesson, arguments.typed);
    if (!values)
        return refuse(values.problems(), arguments.json, wrong);
    ProgressLine line(arguments.json);
    line.working("computing, up to half a minute");
    const Result<lesson::Walk> walk = lesson.teach(*values);
    line.end();
    if (!walk)
        return refuse(walk.problems(), arguments.json, wrong);
    if (!arguments.folder.empty()) {
        if (const int code = draw_and_note(*walk, arguments.folder, arguments.json); code != fine)
            return code;
        if (const int code = film_and_note(*walk, arguments.folder, arguments.json); code != fine)
            return code;
    }
    if (arguments.json)
        say_json(lesson::to_json(lesson, *values, *walk));
    else if (arguments.answer)
        say(sheet::wrapped(walk->question, sheet::text_width) + "\n" + sheet::wrapped(walk->answer, sheet::text_width));
    else
        say(lesson::to_text(lesson, *values, *walk));
    return fine;
}

int write_pages(const fs::path& folder) {
    for (const Lesson& lesson : lesson::all_lessons()) {
        const Result<lesson::Values> values = lesson::read_values(lesson);
        const Result<lesson::Walk> walk = lesson.teach(*values);
        if (!walk)
            return refuse(walk.problems(), false, failed);
        if (const auto files = sheet::draw_all(*walk, folder / lesson.name, {".svg"}); !files)
            return refuse(files.problems(), false, failed);
        if (const auto posters = draw_posters(*walk, folder / lesson.name); !posters)
            return refuse(posters.problems(), false, failed);
        const fs::path page = folder / (lesson.name + ".md");
        if (const auto written = observe::write_whole(page, to_page(lesson, *values, *walk)); !written)
            return refuse(written.problems(), false, failed);
        note("page: " + page.string());
    }
    const auto written = observe::write_whole(folder / "index.md", lesson::contents_page());
    return written ? static_cast<int>(fine) : refuse(written.problems(), false, failed);
}

int list_lessons(bool json) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows;
    for (const Lesson& lesson : lesson::all_lessons()) {
        items.push_back({{"name", lesson.name}, {"title", lesson.title}});
        rows.push_back({lesson.name, lesson.title});
    }
    if (json)
        say_json(items);
    else
        say(table(rows));
    return fine;
}

int lesson_without_name(const LessonArguments& arguments) {
    if (!arguments.unknown.empty())
        return refuse(lesson::find_lesson(arguments.unknown).problems(), arguments.json, wrong);
    return arguments.pages.empty() ? list_lessons(arguments.json) : write_pages(arguments.pages);
}

void add_lesson(CLI::App& all, const Lesson& lesson, Action& action) {
    CLI::App* command = all.add_subcommand(lesson.name, fmt::format("Example: tumble lesson {}{}\n\n{}.", lesson.name,
                                                                    example_of(lesson.parameters), lesson.title));
    const auto arguments = std::make_shared<WalkArguments>();
    add_parameters(*command, lesson.parameters, arguments->typed);
    command
        ->add_option("--out", arguments->folder,
                     "Folder for the figures, as PNG and SVG (needs gnuplot), and videos (ffmpeg)")
        ->type_name("DIR")
        ->check(refuse_dash);
    command->add_flag("--answer", arguments->answer, "Print the question and its answer instead of the walk");
    command->add_flag("--json", arguments->json, "Print the walk as JSON: facts, tables, curves, question, answer");
    command->callback(
        [arguments, &lesson, &action] { action = [arguments, &lesson] { return walk_through(lesson, *arguments); }; });
}

} // namespace

void add_lesson_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "lesson", "Example: tumble lesson two-discs --out figures\n\n"
                  "Fundamentals of the method, step by step, computed by the solvers themselves. Without a name:\n"
                  "lists the lessons.");
    const auto arguments = std::make_shared<LessonArguments>();
    command->require_subcommand(0, 1);
    // Lessons are subcommands; only a word that is none of them ends here.
    command->add_option("NAME", arguments->unknown, "The lesson; `tumble lesson NAME --help` shows its parameters");
    command
        ->add_option("--pages", arguments->pages, "Write every lesson as a Markdown page with figures (needs gnuplot)")
        ->type_name("DIR");
    command->add_flag("--json", arguments->json, "Print the list as JSON");
    command->callback([command, arguments, &action] {
        if (command->get_subcommands().empty())
            action = [arguments] { return lesson_without_name(*arguments); };
    });
    for (const Lesson& lesson : lesson::all_lessons())
        add_lesson(*command, lesson, action);
}

} // namespace tumble::cli
