#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/gallery.h"
#include "cli/program.h"
#include "cli/stop_flag.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <set>
#include <thread>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;

struct GalleryArguments {
    fs::path out;
    fs::path scenes = "scenes";
    std::vector<std::string> only;
    bool list = false;
    bool json = false;
};

using Words = std::vector<std::string>;

Words words_for(const GalleryRun& run, const fs::path& scenes, const fs::path& folder) {
    Words words{"run", (scenes / run.scene).string(), "--out", folder.string()};
    for (const std::string& set : run.sets)
        words.insert(words.end(), {"--set", set});
    return words;
}

Words words_for(const GalleryPicture& picture, const fs::path& folder, const fs::path& file) {
    Words words{"render", folder.string()};
    words.insert(words.end(), picture.flags.begin(), picture.flags.end());
    words.insert(words.end(), {"--out", file.string()});
    return words;
}

/// As if it had been typed, without its words to the terminal but for what is wrong.
int run_quietly(Words words) {
    words.insert(words.begin(), "tumble");
    words.insert(words.end(), {"--force", "--quiet"});
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    return run_program(static_cast<int>(pointers.size()), pointers.data());
}

bool is_stopped(int code) {
    return code == interrupted || code == terminated || code == hung_up;
}

const GalleryRun& run_named(const std::string& name) {
    return *std::find_if(gallery_runs().begin(), gallery_runs().end(),
                         [&](const GalleryRun& run) { return run.name == name; });
}

/// The run's folder below `out`, where it goes and other pictures find it.
fs::path folder_of(const GalleryRun& run, const fs::path& out) {
    return out / ".runs" / run.name;
}

/// Works off the table; what each thing took and whether it came out.
class Workshop {
public:
    Workshop(const GalleryArguments& arguments) : arguments_(arguments) {}

    int work() {
        for (const GalleryPicture& picture : gallery_pictures())
            if (wanted(picture)) {
                if (!has_run(picture.run))
                    continue;
                if (stopped_ || !draw(picture))
                    break;
            }
        std::error_code ignored;
        fs::remove_all(arguments_.out / ".runs", ignored);
        if (stopped_)
            return stop_code();
        say(fmt::format("{} in {}{}", counted(made_, "picture", "pictures"), arguments_.out.string(),
                        failed_.empty() ? "" : fmt::format("; failed: {}", fmt::join(failed_, ", "))));
        return failed_.empty() ? fine : failed;
    }

private:
    [[nodiscard]] bool wanted(const GalleryPicture& picture) const {
        return arguments_.only.empty() ||
               std::find(arguments_.only.begin(), arguments_.only.end(), picture.file) != arguments_.only.end();
    }

    /// Says what it does and how long it took; false when it was stopped.
    bool step(const std::string& what, Words words, bool& came_out) {
        note(fmt::format("{}: tumble {}", what, fmt::join(words, " ")));
        const auto begun = std::chrono::steady_clock::now();
        const int code = run_quietly(std::move(words));
        stopped_ = is_stopped(code);
        came_out = code == fine;
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
        note(fmt::format("{}: {} after {}", what, stopped_ ? "stopped" : (came_out ? "done" : "failed"),
                         duration(taken.count())));
        return !stopped_;
    }

    bool has_run(const std::string& name) {
        if (ran_.contains(name) || broken_.contains(name))
            return ran_.contains(name);
        const GalleryRun& run = run_named(name);
        Words words = words_for(run, arguments_.scenes, folder_of(run, arguments_.out));
        words.insert(words.end(), {"--threads", std::to_string(std::max(1U, std::thread::hardware_concurrency()))});
        bool came_out = false;
        step("run " + name, std::move(words), came_out);
        (came_out ? ran_ : broken_).insert(name);
        if (!came_out && !stopped_)
            for (const GalleryPicture& picture : gallery_pictures())
                if (picture.run == name && wanted(picture))
                    failed_.push_back(picture.file);
        return came_out || stopped_;
    }

    bool draw(const GalleryPicture& picture) {
        bool came_out = false;
        const fs::path folder = folder_of(run_named(picture.run), arguments_.out);
        if (!step(picture.file, words_for(picture, folder, arguments_.out / picture.file), came_out))
            return false;
        if (came_out)
            ++made_;
        else
            failed_.push_back(picture.file);
        return true;
    }

    const GalleryArguments& arguments_;
    std::set<std::string> ran_, broken_;
    std::vector<std::string> failed_;
    int made_ = 0;
    bool stopped_ = false;
};

/// What is made, and by which commands; as somebody would type them.
int list_pictures(const GalleryArguments& arguments) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows;
    for (const GalleryPicture& picture : gallery_pictures()) {
        const GalleryRun& run = run_named(picture.run);
        const fs::path folder = fs::path("out") / run.name;
        const std::string ran = fmt::format("{}", fmt::join(words_for(run, "scenes", folder), " "));
        const std::string drawn = fmt::format("{}", fmt::join(words_for(picture, folder, picture.file), " "));
        items.push_back({{"file", picture.file}, {"shows", picture.shows}, {"run", ran}, {"render", drawn}});
        rows.push_back({picture.file, picture.shows, "tumble " + drawn});
    }
    if (arguments.json)
        say_json(items);
    else
        say(table(rows));
    return fine;
}

int check_names(const GalleryArguments& arguments) {
    for (const std::string& name : arguments.only) {
        const auto& all = gallery_pictures();
        if (std::none_of(all.begin(), all.end(), [&](const GalleryPicture& p) { return p.file == name; }))
            return refuse({{.what = fmt::format("the gallery has no picture '{}'", name),
                            .fix = "`tumble gallery --list` names all there are"}},
                          arguments.json, wrong);
    }
    return fine;
}

int make_gallery(const GalleryArguments& arguments) {
    if (arguments.list)
        return list_pictures(arguments);
    if (const int code = check_names(arguments); code != fine)
        return code;
    if (arguments.out.empty())
        return refuse(
            {{.what = "the pictures need a folder", .fix = "write --out docs/gallery, or --list to see them"}},
            arguments.json, wrong);
    if (!fs::is_directory(arguments.scenes))
        return refuse({{.file = arguments.scenes.string(),
                        .what = "is no folder with scenes",
                        .fix = "start where the scenes are, or write --scenes DIR"}},
                      arguments.json, wrong);
    watch_for_stop();
    return Workshop(arguments).work();
}

} // namespace

void add_gallery_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "gallery", "Example: tumble gallery --out docs/gallery\n\n"
                   "Runs shortened scenes and makes the pictures of docs/gallery.md from them: some minutes.\n"
                   "Says what it does; a picture that fails does not keep the others from being made.");
    const auto arguments = std::make_shared<GalleryArguments>();
    command->add_option("PICTURE", arguments->only, "Only these, such as strip.png");
    command->add_option("--out", arguments->out, "Where they go; what has their names is replaced")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_option("--scenes", arguments->scenes, "Folder of the scenes")->type_name("DIR");
    command->add_flag("--list", arguments->list, "Only say which there are, and the commands that make them");
    command->add_flag("--json", arguments->json, "Print the list as JSON");
    command->callback([arguments, &action] { action = [arguments] { return make_gallery(*arguments); }; });
}

} // namespace tumble::cli
