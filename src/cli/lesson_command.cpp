#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "lesson/film.h"
#include "lesson/plot.h"
#include "lesson/show.h"
#include "observe/whole_file.h"

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
    std::vector<std::pair<std::string, std::string>> typed; // parameter, number
    fs::path folder;                                        // for figures; empty: none
    bool json = false;
    bool answer = false;
};

std::optional<Problem> make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return Problem{.file = folder.string(), .what = "cannot be made: " + error.message()};
    return std::nullopt;
}

/// Draws every figure once per ending, and every film as a picture. The files written, or what went wrong.
Result<std::vector<fs::path>> draw_figures(const lesson::Walk& walk, const fs::path& folder,
                                           const std::vector<std::string>& endings) {
    if (const auto problem = make_folder(folder))
        return *problem;
    std::vector<fs::path> files;
    for (const lesson::Figure* figure : walk.figures())
        for (const std::string& ending : endings) {
            files.push_back(folder / (figure->name + ending));
            if (const Result<Done> drawn = lesson::draw(*figure, files.back()); !drawn)
                return drawn.problems();
        }
    for (const lesson::Film* film : walk.films()) {
        files.push_back(folder / (film->name + ".png"));
        if (const Result<Done> drawn = lesson::draw_poster(*film, files.back()); !drawn)
            return drawn.problems();
    }
    return files;
}

/// Films move only where ffmpeg is; their pictures are there without.
void shoot_films(const lesson::Walk& walk, const fs::path& folder) {
    for (const lesson::Film* film : walk.films()) {
        const fs::path file = folder / (film->name + ".mp4");
        const Result<Done> shot = lesson::shoot(*film, file);
        note(shot ? "video: " + file.string() : "no video: " + to_string(shot.problems().front()));
    }
}

int walk_through(const Lesson& lesson, const WalkArguments& arguments) {
    const Result<lesson::Values> values = lesson::read_values(lesson, arguments.typed);
    if (!values)
        return refuse(values.problems(), arguments.json, wrong);
    const Result<lesson::Walk> walk = lesson.teach(*values);
    if (!walk)
        return refuse(walk.problems(), arguments.json, wrong);
    if (!arguments.folder.empty()) {
        const auto files = draw_figures(*walk, arguments.folder, {".png", ".svg"});
        if (!files)
            return refuse(files.problems(), arguments.json, failed);
        for (const fs::path& file : *files)
            note("figure: " + file.string());
        shoot_films(*walk, arguments.folder);
    }
    if (arguments.json)
        say_json(lesson::to_json(lesson, *values, *walk));
    else if (arguments.answer)
        say(lesson::wrapped(walk->question, 96) + "\n" + lesson::wrapped(walk->answer, 96));
    else
        say(lesson::to_text(lesson, *values, *walk));
    return fine;
}

int write_pages(const fs::path& folder) {
    if (const auto problem = make_folder(folder))
        return refuse({*problem}, false, failed);
    for (const Lesson& lesson : lesson::all_lessons()) {
        const Result<lesson::Values> values = lesson::read_values(lesson);
        const Result<lesson::Walk> walk = lesson.teach(*values);
        if (!walk)
            return refuse(walk.problems(), false, failed);
        if (const auto files = draw_figures(*walk, folder / lesson.name, {".svg"}); !files)
            return refuse(files.problems(), false, failed);
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
    const std::string example =
        lesson.parameters.empty()
            ? ""
            : fmt::format(" --{} {}", lesson.parameters.front().name, scene::plain(lesson.parameters.front().standard));
    CLI::App* command = all.add_subcommand(
        lesson.name, fmt::format("Example: tumble lesson {}{}\n\n{}.", lesson.name, example, lesson.title));
    const auto arguments = std::make_shared<WalkArguments>();
    for (const lesson::Parameter& parameter : lesson.parameters)
        command
            ->add_option_function<std::string>(
                "--" + parameter.name,
                [arguments, name = parameter.name](const std::string& text) {
                    arguments->typed.emplace_back(name, text);
                },
                fmt::format("{} ({}; {} without it)", parameter.sentence, describe(parameter),
                            scene::plain(parameter.standard)))
            ->type_name("X");
    command
        ->add_option("--out", arguments->folder,
                     "Folder for the figures, as PNG and SVG (needs gnuplot), and videos (ffmpeg)")
        ->type_name("DIR");
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
