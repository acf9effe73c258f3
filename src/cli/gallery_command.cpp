#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/gallery_workshop.h"
#include "cli/stop_flag.h"

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
    bool quick = false;
    bool list = false;
    bool json = false;
};

std::string minutes_in_words(const GalleryPicture& picture) {
    const int minutes = minutes_of(picture);
    return minutes == 0 ? "" : fmt::format("{} min", minutes);
}

/// What is made, and by which commands; as somebody would type them.
int list_pictures(bool json) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows;
    for (const GalleryPicture& picture : gallery_pictures()) {
        const GalleryRecipe recipe = recipe_of(picture);
        items.push_back({{"file", picture.file},
                         {"shows", picture.shows},
                         {"minutes", minutes_of(picture)},
                         {"commands", recipe.commands},
                         {"result", recipe.result}});
        rows.push_back({picture.file, picture.shows, minutes_in_words(picture), recipe.commands.back()});
    }
    if (json)
        say_json(items);
    else
        say(table(rows));
    return fine;
}

Result<std::vector<const GalleryPicture*>> wanted(const GalleryArguments& arguments) {
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
        if (arguments.only.empty() && !(arguments.quick && minutes_of(picture) > 0))
            found.push_back(&picture);
    return found;
}

/// Said before the wait.
void tell_what_takes_minutes(const std::vector<const GalleryPicture*>& pictures) {
    std::vector<std::string> slow;
    for (const GalleryPicture* picture : pictures)
        if (minutes_of(*picture) > 0)
            slow.push_back(fmt::format("{} ({})", picture->file, minutes_in_words(*picture)));
    if (!slow.empty())
        note(fmt::format("these take minutes on two cores, and --quick leaves them out: {}", fmt::join(slow, ", ")));
}

int make_gallery(const GalleryArguments& arguments) {
    if (arguments.list)
        return list_pictures(arguments.json);
    const auto pictures = wanted(arguments);
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
    tell_what_takes_minutes(*pictures);
    return Workshop(arguments.out, arguments.scenes).make(*pictures);
}

} // namespace

void add_gallery_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "gallery",
        "Example: tumble gallery --out docs/gallery\n\n"
        "Makes the pictures that README and docs show, but for those that docs/gallery.md names, from shipped\n"
        "scenes. Says what it does; a picture that fails does not keep the others from being made, and one call\n"
        "goes on where another was stopped or killed.");
    const auto arguments = std::make_shared<GalleryArguments>();
    CLI::Option* only = command->add_option("PICTURE,--only", arguments->only, "Only these, such as strip.png");
    command->add_option("--out", arguments->out, "Where they go; what has their names is replaced")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_option("--scenes", arguments->scenes, "Folder of the scenes")->type_name("DIR");
    command->add_flag("--quick", arguments->quick, "Leave out what takes minutes")->excludes(only);
    command->add_flag("--list", arguments->list, "Only say which there are, and the commands that make them");
    command->add_flag("--json", arguments->json, "Print the list as JSON");
    command->callback([arguments, &action] { action = [arguments] { return make_gallery(*arguments); }; });
}

} // namespace tumble::cli
