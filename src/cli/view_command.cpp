#include "base/ending.h"
#include "base/growing_file.h"
#include "base/make_folder.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/render_settings.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "cli/time_range.h"
#include "observe/whole_file.h"
#include "render/png_writer.h"
#include "run/run_folder.h"
#include "view/live_source.h"
#include "view/opener.h"
#include "view/recorded_source.h"
#include "view/still.h"
#include "view/viewer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <thread>

namespace tumble::cli {

namespace {

struct ViewArguments {
    std::filesystem::path what; // a run's folder or a scene file
    SceneArguments scene;
    std::filesystem::path out = "out/view";
    view::ViewerOptions viewer;
    std::filesystem::path picture; // of what a browser would show, in its place; empty: none
    std::string time;              // that it shows
    std::string tab;
    bool force = false;
    int threads = 1;
    bool no_open = false;
    bool quiet = false;
    bool json = false;
};

/// The window of the one who typed the command, if there is a screen to have one on.
std::unique_ptr<view::Opener> open_browser(const view::Server& server, const std::filesystem::path& folder) {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
        return nullptr;
    auto opener = view::Opener::open(server.link(), folder, [&server](const std::string& why) {
        note(fmt::format("{}: open the link yourself: {}", why, server.link()));
    });
    if (!opener) {
        note(to_string(opener.problems().front()));
        return nullptr;
    }
    return std::move(*opener);
}

/// A scene, or the one in a run's folder, as it is written and as it is meant.
struct Watched {
    view::SceneText text;
    scene::Scene scene;
    std::unique_ptr<view::Source> source;
    view::Plots plots;
};

Result<Watched> open_watched(ViewArguments& arguments, const std::shared_ptr<view::Bell>& bell) {
    std::error_code ignored;
    // A name of nothing is that of a run, as for `render`, unless it says that it is a scene's.
    const bool folder = std::filesystem::is_directory(arguments.what, ignored) ||
                        (ending_of(arguments.what) != ".toml" && !std::filesystem::exists(arguments.what, ignored));
    const std::filesystem::path file = folder ? arguments.what / "scene.toml" : arguments.what;
    if (folder) {
        if (const auto found = run::find_run(arguments.what); !found)
            return found.problems();
        if (auto problems = refuse_sets_of_the_run(arguments.scene.sets, file); !problems.empty())
            return problems;
    }
    std::vector<scene::Override> sets;
    for (const std::string& set : arguments.scene.sets)
        sets.push_back({set});
    auto text = view::SceneText::read(file, std::move(sets));
    if (!text)
        return text.problems();
    auto scene = text->load();
    if (!scene)
        return arguments.scene.of_flags(scene.problems());
    const auto news = [bell] { bell->ring(); };
    auto source = folder ? view::open_recorded(arguments.what, *scene, news)
                         : view::open_live(*text, *scene, arguments.threads, news);
    if (!source)
        return source.problems();
    view::Plots plots =
        folder ? view::Plots::of_run(arguments.what, *scene) : view::Plots::of_simulation(*scene, *(*source)->layout());
    return Watched{std::move(*text), std::move(*scene), std::move(*source), std::move(plots)};
}

/// What is wrong with the flags of a picture, before anything is opened.
Problems refuse_picture(const ViewArguments& arguments) {
    if (arguments.picture.empty() && !(arguments.time.empty() && arguments.tab.empty()))
        return {{.what = "--time and --tab say what a picture shows, and none is asked for",
                 .fix = "add --picture F.png, or leave them away: in the browser hands choose"}};
    if (!arguments.force && !arguments.picture.empty())
        if (const auto problem = refuse_to_overwrite({arguments.picture}))
            return {*problem};
    if (arguments.picture.empty())
        return {};
    if (const auto made = make_folder(std::filesystem::absolute(arguments.picture).parent_path()); !made)
        return made.problems();
    return check_writable(arguments.picture).problems();
}

/// A size that was asked for and that no window has. Of scenes that say their own it is taken as near as it goes.
std::optional<Problem> refuse_size(const ViewArguments& arguments, const scene::Render& look) {
    const auto sizes = [](const std::string& set) {
        return set.starts_with("render.width") || set.starts_with("render.height") || set.starts_with("render.dpi");
    };
    const bool fits = look.width >= view::Studio::least_width && look.width <= view::Studio::most_side &&
                      look.height >= view::Studio::least_height && look.height <= view::Studio::most_side;
    if (fits || std::none_of(arguments.scene.sets.begin(), arguments.scene.sets.end(), sizes))
        return std::nullopt;
    return Problem{
        .what = fmt::format("a picture of {} x {} pixels is none that the view can draw", look.width, look.height),
        .fix = fmt::format("take from {} to {} pixels of width and from {} to {} of height, such as {}",
                           view::Studio::least_width, view::Studio::most_side, view::Studio::least_height,
                           view::Studio::most_side, look.paper ? "--size-mm 120x80 --dpi 300" : "--size 1280x720")};
}

/// Of a run frames may be rarer than what was asked for: one more could have come until then, and no further.
void note_end(const ViewArguments& arguments, view::Source& source, const scene::Scene& scene, double wanted) {
    const double last = source.state().last;
    const double end = std::max(last, std::min(scene.duration, last + scene.render.every));
    if (!std::isfinite(wanted) || wanted <= end + 0.5 * scene.step() || arguments.quiet)
        return;
    note(fmt::format("warning: {} at t = {:.6g} s, which is what the picture shows: --time asked for {:.6g} s",
                     source.can_seek() ? "the frames of this run end" : "this scene ends", last, wanted));
}

int keep_picture(const ViewArguments& arguments, view::Studio& studio, const scene::Scene& scene) {
    view::StillWishes wishes{.step = scene.step(), .every = scene.render.every, .tab = arguments.tab};
    if (const auto problem = read_time_range(arguments.time, wishes.from, wishes.to))
        return refuse({*problem}, arguments.json, wrong);
    if (const auto shown = studio.source().find(wishes.from, wishes.to); !shown)
        return refuse(shown.problems(), arguments.json, wrong);
    note_end(arguments, studio.source(), scene, wishes.to);
    ProgressLine line(arguments.quiet || arguments.json);
    wishes.reached = [&line, end = std::min(wishes.to, scene.duration)](double time) {
        line.working(fmt::format("{:.4g} of {:.4g} s", time, end));
    };
    const auto picture = view::take_still(studio, wishes, &watch_for_stop());
    line.end();
    if (stop_wanted(&watch_for_stop()))
        return stop_code();
    if (!picture)
        return refuse(picture.problems(), arguments.json, failed);
    const std::vector<std::uint8_t> bytes = render::encode_png(*picture);
    if (const auto kept = observe::write_whole(arguments.picture, std::string(bytes.begin(), bytes.end())); !kept)
        return refuse(kept.problems(), arguments.json, failed);
    if (arguments.json)
        say_json(nlohmann::ordered_json{{"picture", arguments.picture.string()}});
    else if (!arguments.quiet)
        say(arguments.picture.string());
    return fine;
}

int view_it(ViewArguments& arguments) {
    if (const Problems problems = refuse_picture(arguments); !problems.empty())
        return refuse(problems, arguments.json, wrong);
    const auto bell = std::make_shared<view::Bell>();
    auto watched = open_watched(arguments, bell);
    if (!watched)
        return refuse(watched.problems(), arguments.json, wrong);
    if (!arguments.picture.empty())
        if (const auto problem = refuse_size(arguments, watched->scene.render))
            return refuse({*problem}, arguments.json, wrong);
    for (const std::string& warning : watched->source->warnings())
        if (!arguments.quiet)
            note("warning: " + warning);
    const view::StudioOptions options{watched->scene.render.width, watched->scene.render.height, arguments.out};
    auto studio = view::Studio::open(std::move(watched->source), watched->text, watched->scene,
                                     std::move(watched->plots), options);
    if (!studio)
        return refuse(studio.problems(), arguments.json, wrong);
    if (!arguments.picture.empty())
        return keep_picture(arguments, **studio, watched->scene);
    const auto tell_link = [&arguments](const std::string& link) {
        if (arguments.json)
            say(nlohmann::ordered_json{{"link", link}}.dump());
        else
            say(link);
    };
    auto viewer = view::Viewer::open(std::move(*studio), bell, arguments.viewer, tell_link);
    if (!viewer)
        return refuse(viewer.problems(), arguments.json, wrong);
    if (!arguments.quiet)
        note("the newest of these links opens the view in a browser on this machine, once; Ctrl-C ends it");
    const auto browser = arguments.no_open ? nullptr : open_browser((*viewer)->server(), arguments.out);
    const Result<Done> done = (*viewer)->run(&watch_for_stop());
    return done ? static_cast<int>(fine) : refuse(done.problems(), arguments.json, failed);
}

} // namespace

void add_view_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "view", "Example: tumble view scenes/drum-2d.toml\n\n"
                "Simulates a scene, or shows a run that is over, drawn on this machine and seen in a browser on it.\n"
                "Prints the link to open; nobody else can. docs/view.md says what hands can do.");
    const auto arguments = std::make_shared<ViewArguments>();
    arguments->threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); // one draws
    command->add_option("SCENE|RUN", arguments->what, "A scene file, or the folder of a run")->required();
    command->add_option("--port", arguments->viewer.port, "Port of 127.0.0.1; any that is free without it")
        ->type_name("N")
        ->check(whole_number_from(0, 65535));
    command->add_flag("--no-open", arguments->no_open, "Only print the link, open no browser");
    command->add_option("--quality", arguments->viewer.quality, "Of the frames' JPEG, 1 to 100; 80 without it")
        ->type_name("Q")
        ->check(whole_number_from(1, 100));
    command->add_option("--threads", arguments->threads, "Threads that step; never the result")
        ->type_name("N")
        ->check(whole_number_from(1, 256));
    command->add_option("--out", arguments->out, "Folder for pictures, films and scenes that are kept")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command
        ->add_option("--picture", arguments->picture,
                     "Only draw what a browser would show, panel and all, into this file; opens no port")
        ->type_name("F.png")
        ->check(ends_in({".png"}));
    command
        ->add_option("--time", arguments->time,
                     "Of --picture: the time that it shows, B, and the one from which what it shows is seen, A; s")
        ->type_name("A:B");
    command->add_option("--tab", arguments->tab, "Of --picture: the tab of the panel")
        ->type_name("T")
        ->check(one_of({"Plots", "Change", "Look", "Keep"}));
    command->add_flag("--force", arguments->force, "Of --picture: replace what is there");
    add_render_settings(*command, arguments->scene);
    arguments->scene.add_sets_to(*command);
    command->add_flag("--quiet", arguments->quiet, "Nothing but the link");
    command->add_flag("--json", arguments->json, "Print each link as a JSON object on a line");
    command->callback([arguments, &action] { action = [arguments] { return view_it(*arguments); }; });
}

} // namespace tumble::cli
