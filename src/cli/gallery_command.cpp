#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/gallery_workshop.h"
#include "cli/stop_flag.h"
#include "run/run_folder.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace tumble::cli {

namespace {

struct GalleryArguments {
    std::filesystem::path out;
    std::filesystem::path scenes = "scenes";
    std::vector<std::string> only;
    std::vector<std::string> runs; // "NAME=DIR"
    bool quick = false;
    bool list = false;
    bool json = false;
};

std::string minutes_in_words(int minutes) {
    return minutes == 0 ? "" : minutes < 100 ? fmt::format("{} min", minutes) : fmt::format("{:.1f} h", minutes / 60.0);
}

bool is_filled(const std::filesystem::path& folder, const GalleryRun& run) {
    std::error_code ignored;
    return run.words.front() == "run" ? run::find_run(folder).ok() : std::filesystem::is_directory(folder, ignored);
}

Result<GivenRuns> read_runs(const std::vector<std::string>& words) {
    GivenRuns given;
    Problems problems;
    std::vector<std::string> names;
    for (const GalleryRun& run : gallery_runs())
        names.push_back(run.name);
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const std::filesystem::path folder = equals == std::string::npos ? "" : word.substr(equals + 1);
        const auto run = std::find_if(gallery_runs().begin(), gallery_runs().end(),
                                      [&](const GalleryRun& one) { return one.name == name; });
        const std::string guess = did_you_mean(name, names);
        const auto refuse_it = [&](const std::string& what) {
            problems.push_back({.what = fmt::format("--run {}: {}", excerpt(word), what),
                                .fix = fmt::format("write --run NAME=DIR with one of {}", fmt::join(names, ", "))});
        };
        if (equals == std::string::npos)
            refuse_it("there is no = between a name and a folder");
        else if (run == gallery_runs().end())
            refuse_it(fmt::format("the gallery has no run '{}'{}", excerpt(name), guess.empty() ? "" : "; " + guess));
        else if (folder.empty())
            refuse_it("no folder is named");
        else if (given.contains(name))
            refuse_it("this run is given twice");
        else if (!is_filled(folder, *run))
            problems.push_back({.file = folder.string(),
                                .what = fmt::format("is no folder that the run {} has filled", name),
                                .fix = "leave --run away, and it is run anew; `tumble gallery --list` says how"});
        else
            given[name] = folder;
    }
    if (!problems.empty())
        return problems;
    return given;
}

/// What is made, and by which commands; as somebody would type them.
int list_pictures(bool json) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows;
    for (const GalleryPicture& picture : gallery_pictures()) {
        const GalleryRecipe recipe = recipe_of(picture);
        std::vector<std::string> runs;
        for (const GalleryRun* run : runs_of(picture))
            runs.push_back(run->name);
        items.push_back({{"file", picture.file},
                         {"shows", picture.shows},
                         {"minutes", minutes_of(picture)},
                         {"runs", runs},
                         {"commands", recipe.commands},
                         {"result", recipe.result}});
        rows.push_back({picture.file, picture.shows, minutes_in_words(minutes_of(picture)),
                        runs.empty() ? "" : fmt::format("run {}", fmt::join(runs, ", ")), recipe.commands.back()});
    }
    if (json)
        say_json(items);
    else
        say(table(rows));
    return fine;
}

Result<std::vector<const GalleryPicture*>> wanted(const GalleryArguments& arguments, const GivenRuns& given) {
    std::vector<const GalleryPicture*> found;
    Problems problems;
    const auto& all = gallery_pictures();
    for (const std::string& name : arguments.only) {
        const auto named = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.file == name; });
        if (named == all.end())
            problems.push_back({.what = fmt::format("the gallery has no picture '{}'", name),
                                .fix = "`tumble gallery --list` names all there are"});
        else
            found.push_back(&*named);
    }
    if (!problems.empty())
        return problems;
    for (const GalleryPicture& picture : all)
        if (arguments.only.empty() && !(arguments.quick && minutes_of(picture, given) > 0))
            found.push_back(&picture);
    return found;
}

/// Said before the wait.
void tell_what_takes_minutes(const std::vector<const GalleryPicture*>& pictures, const GivenRuns& given) {
    std::vector<std::string> slow;
    for (const GalleryPicture* picture : pictures)
        if (const int minutes = minutes_of(*picture, given); minutes > 0)
            slow.push_back(fmt::format("{} ({})", picture->file, minutes_in_words(minutes)));
    if (!slow.empty())
        note(fmt::format("these take minutes on two cores, and --quick leaves them out: {}", fmt::join(slow, ", ")));
}

int make_gallery(const GalleryArguments& arguments) {
    if (arguments.list)
        return list_pictures(arguments.json);
    const auto given = read_runs(arguments.runs);
    if (!given)
        return refuse(given.problems(), arguments.json, wrong);
    const auto pictures = wanted(arguments, *given);
    if (!pictures)
        return refuse(pictures.problems(), arguments.json, wrong);
    if (arguments.out.empty())
        return refuse(
            {{.what = "the pictures need a folder", .fix = "write --out docs/gallery, or --list to see them"}},
            arguments.json, wrong);
    if (!std::filesystem::is_directory(arguments.scenes))
        return refuse({{.file = arguments.scenes.string(),
                        .what = "is no folder with scenes",
                        .fix = "start where the scenes are, or write --scenes DIR"}},
                      arguments.json, wrong);
    watch_for_stop();
    tell_what_takes_minutes(*pictures, *given);
    return Workshop(arguments.out, arguments.scenes, *given).make(*pictures);
}

} // namespace

void add_gallery_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "gallery",
        "Example: tumble gallery --out docs/gallery\n\n"
        "Makes all pictures that README and docs show, but for those of lessons, from shipped scenes, what takes\n"
        "long last. Says what it does; a picture that fails does not keep the others from being made, and one\n"
        "call goes on where another was stopped or killed.");
    const auto arguments = std::make_shared<GalleryArguments>();
    CLI::Option* only = command->add_option("PICTURE,--only", arguments->only, "Only these, such as strip.png");
    command->add_option("--out", arguments->out, "Where they go; what has their names is replaced")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_option("--scenes", arguments->scenes, "Folder of the scenes")->type_name("DIR");
    command
        ->add_option("--run", arguments->runs,
                     "A run of the table that is there already, such as bowl-full=out/bowl; others are run")
        ->type_name("NAME=DIR")
        ->allow_extra_args(false);
    command->add_flag("--quick", arguments->quick, "Leave out what takes minutes")->excludes(only);
    command->add_flag("--list", arguments->list, "Only say which there are, and the commands that make them");
    command->add_flag("--json", arguments->json, "Print the list as JSON");
    command->callback([arguments, &action] { action = [arguments] { return make_gallery(*arguments); }; });
}

} // namespace tumble::cli
