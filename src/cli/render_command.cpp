#include "base/ending.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/render_settings.h"
#include "cli/run_outcome.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "cli/time_range.h"
#include "render/drawing_file.h"
#include "render/video_writer.h"
#include "run/beside.h"
#include "run/redraw.h"
#include "run/run_scene.h"
#include "run/strip.h"
#include "run/tracers.h"

#include <fmt/format.h>
#include <memory>
#include <optional>
#include <set>
#include <thread>

namespace tumble::cli {

namespace {

constexpr std::int64_t most_parts = 100; // pictures in one, along each side

struct RenderArguments {
    std::filesystem::path what;   // a run's folder or a scene file
    std::filesystem::path beside; // another run's folder; empty: none
    std::string labels;
    SceneArguments scene;
    std::filesystem::path out;
    std::filesystem::path video;
    std::string time;
    std::string strip;    // "6" or "3x2"
    std::string sections; // "6", or places in m as "0,0.027"
    bool frames = false;
    bool force = false;
    bool quiet = false;
    bool json = false;
};

int tell_replayed(const run::Replayed& done, const run::PictureTargets& targets, const scene::Render& settings,
                  const RenderArguments& arguments) {
    const bool as_lines = !targets.drawing.empty();
    for (const std::string& warning : done.warnings)
        if (!arguments.quiet)
            note("warning: " + warning);
    if (arguments.json)
        say_json(nlohmann::ordered_json{{"frames", done.frames},
                                        {"first_s", done.first},
                                        {"last_s", done.last},
                                        {"stopped", done.stopped},
                                        {"pictures", (as_lines ? targets.drawing : targets.folder).string()},
                                        {"video", targets.video.string()},
                                        {"warnings", done.warnings}});
    else if (!arguments.quiet)
        say(fmt::format("{}: {} from t = {:.4g} to {:.4g} s{}{}",
                        (as_lines                 ? targets.drawing
                         : targets.folder.empty() ? targets.video
                                                  : targets.folder)
                            .string(),
                        counted(done.frames, "picture", "pictures"), done.first, done.last,
                        done.stopped ? ", where it was stopped before its end" : "",
                        targets.video.empty() ? "" : "; the video " + video_pace(settings.slowdown())));
    return done.stopped ? stop_code() : static_cast<int>(fine);
}

/// Folder and file that pictures go to; `name` is that of the folder for PNG files where none was given.
run::PictureTargets targets_of(const RenderArguments& arguments, const std::string& name) {
    if (render::is_drawing_file(arguments.out))
        return {.folder = {}, .video = {}, .drawing = arguments.out};
    run::PictureTargets targets{{}, arguments.video};
    if (arguments.frames || arguments.video.empty() || !arguments.out.empty())
        targets.folder = !arguments.out.empty() ? arguments.out : arguments.what / "redrawn" / name;
    return targets;
}

int tell_drawn(const Result<run::Replayed>& done, const run::PictureTargets& targets, const scene::Render& settings,
               const RenderArguments& arguments) {
    if (!done)
        return refuse(done.problems(), arguments.json, wrong);
    if (!done->reason.empty())
        // Words without room are found while drawing, but it is the settings that are wrong.
        return refuse(done->reason, arguments.json, done->reason.front().key.empty() ? failed : wrong);
    return tell_replayed(*done, targets, settings, arguments);
}

int draw_both(const RenderArguments& arguments, const scene::Scene& scene) {
    if (const auto found = run::find_run(arguments.beside); !found)
        return refuse(found.problems(), arguments.json, wrong);
    run::BesideOptions options;
    options.settings = scene.render;
    options.overwrite = arguments.force;
    options.when.stop = &watch_for_stop();
    if (const auto problem = read_time_range(arguments.time, options.when.from, options.when.to, arguments.what))
        return refuse({*problem}, arguments.json, wrong);
    if (!arguments.labels.empty()) {
        const std::size_t comma = arguments.labels.find(',');
        if (comma == std::string::npos)
            return refuse({{.what = "--labels takes two words, for the left and the right run",
                            .fix = "write --labels LEFT,RIGHT"}},
                          arguments.json, wrong);
        options.labels = {arguments.labels.substr(0, comma), arguments.labels.substr(comma + 1)};
    }
    options.targets = targets_of(arguments, fmt::format("beside_{}", run::folder_name(arguments.beside)));
    ProgressLine line(arguments.quiet);
    const auto done = run::draw_beside({arguments.what, arguments.beside}, options,
                                       [&](std::int64_t n, std::int64_t all) { line.frames(n, all); });
    line.end();
    return tell_drawn(done, options.targets, options.settings, arguments);
}

/// A name that ends as files do which nothing here writes, and which would become a folder's; a folder that is there
/// may be called what it likes.
std::optional<Problem> refuse_ending(const RenderArguments& arguments, bool scene) {
    static const std::set<std::string> others{".jpg",  ".jpeg", ".gif",  ".bmp", ".tif",  ".tiff", ".webp", ".eps",
                                              ".ps",   ".txt",  ".csv",  ".doc", ".docx", ".avi",  ".mov",  ".mkv",
                                              ".webm", ".mpg",  ".mpeg", ".wmv", ".toml", ".json"};
    const std::string ending = ending_of(arguments.out);
    std::error_code ignored;
    if (std::filesystem::is_directory(arguments.out, ignored))
        return std::nullopt;
    if (ending == ".mp4")
        return Problem{.file = arguments.out.string(),
                       .what = "is the name of a video, and --out is for pictures",
                       .fix = fmt::format("write --video {}", arguments.out.string())};
    if (scene && ending == ".png")
        return Problem{.file = arguments.out.string(),
                       .what = "is the name of a picture, and --out names the folder of a scene's run here",
                       .fix = "run the scene first, then give the run's folder, with --strip 1 for one picture"};
    if (!others.contains(ending))
        return std::nullopt;
    return Problem{.file = arguments.out.string(),
                   .what = fmt::format("pictures are not written as {}", ending),
                   .fix = scene ? "name a folder: --out is that of the run"
                                : "name a folder, for PNG files of all frames; or a file, in .svg or .pdf for the last "
                                  "frame in two dimensions, in .png with --strip or --sections"};
}

std::optional<Problem> refuse_video(const std::filesystem::path& video) {
    auto problem = video.empty() ? std::nullopt : render::refuse_video_name(video);
    if (problem && (ending_of(video) == ".png" || render::is_drawing_file(video))) {
        problem->what = "is the name of a picture, and --video makes an MP4 file";
        problem->fix += "; --out is for pictures";
    }
    return problem;
}

std::optional<Problem> refuse_with_one_file(const RenderArguments& arguments) {
    std::error_code ignored;
    if (ending_of(arguments.out) != ".png" || std::filesystem::is_directory(arguments.out, ignored))
        return std::nullopt;
    return Problem{.file = arguments.out.string(),
                   .what = "is the name of a picture, and all frames go to a folder",
                   .fix = arguments.beside.empty()
                              ? "--strip 1 draws the last frame alone into that file; or name a folder"
                              : "name a folder; --time A: leaves the frames from A on, such as the last alone"};
}

std::optional<Problem> refuse_with_lines(const RenderArguments& arguments) {
    if (render::is_drawing_file(arguments.out) && (arguments.frames || !arguments.video.empty()))
        return Problem{.what = fmt::format("{} is one drawing, of the last frame", arguments.out.string()),
                       .fix = "leave --video and --frames away; --time :B takes another frame"};
    return std::nullopt;
}

/// "6", or columns and rows as "3x2"; nothing for other words.
std::optional<render::StripPlan> read_plan(const std::string& text) {
    const std::size_t cross = text.find('x');
    const auto columns = parse_integer(text.substr(0, cross));
    const auto rows = cross == std::string::npos ? Result<std::int64_t>(1) : parse_integer(text.substr(cross + 1));
    if (!columns || !rows || *columns < 1 || *rows < 1 || *columns > most_parts || *rows > most_parts)
        return std::nullopt;
    return render::StripPlan{.cells = static_cast<int>(*columns * *rows),
                             .columns = cross == std::string::npos ? 0 : static_cast<int>(*columns)};
}

std::optional<Problem> refuse_with_strip(const RenderArguments& arguments) {
    if (!arguments.strip.empty() && !arguments.sections.empty())
        return Problem{.what = "--strip and --sections are two ways to put pictures into one",
                       .fix = "leave one of them away; --time B: chooses when sections are taken"};
    if (!arguments.beside.empty() || !arguments.video.empty() || arguments.frames)
        return Problem{.what = "a strip or sections are one picture of one run",
                       .fix = "leave --beside, --video and --frames away"};
    return std::nullopt;
}

/// A whole number is one of sections; with a comma or a point it is their places, m.
Result<Done> read_sections(const std::string& text, run::StripOptions& options) {
    const Problem unreadable{
        .what = fmt::format("--sections {} is neither a number of pictures nor places", excerpt(text)),
        .fix = fmt::format("write --sections 6 for 1 to {} of them, or places in m as --sections 0,0.027", most_parts)};
    if (text.find_first_of(",.") == std::string::npos) {
        const auto count = parse_integer(text);
        if (!count || *count < 1 || *count > most_parts)
            return unreadable;
        options.plan.cells = static_cast<int>(*count);
        return Done{};
    }
    for (const std::string_view part : split(text, ',')) {
        const auto place = parse_number(trimmed(part));
        if (!place || static_cast<std::int64_t>(options.places.size()) == most_parts)
            return unreadable;
        options.places.push_back(*place);
    }
    options.plan.cells = static_cast<int>(options.places.size());
    return Done{};
}

Result<Done> read_parts(const RenderArguments& arguments, run::StripOptions& options) {
    if (const auto problem = refuse_with_strip(arguments))
        return *problem;
    options.sections = !arguments.sections.empty();
    if (options.sections)
        return read_sections(arguments.sections, options);
    const auto plan = read_plan(arguments.strip);
    if (!plan)
        return Problem{.what = fmt::format("--strip {} is no number of pictures", arguments.strip),
                       .fix = fmt::format(
                           "write --strip 6, or columns and rows as --strip 3x2; at most {} along a side", most_parts)};
    options.plan = *plan;
    return Done{};
}

int draw_parts(const RenderArguments& arguments, run::RedrawOptions&& redraw) {
    run::StripOptions options;
    options.redraw = std::move(redraw);
    if (const auto read = read_parts(arguments, options); !read)
        return refuse(read.problems(), arguments.json, wrong);
    const scene::Render& settings = options.redraw.settings;
    options.out = !arguments.out.empty() ? arguments.out
                                         : arguments.what / "redrawn" /
                                               fmt::format("{}_{}_{}_{}.png", settings.camera, settings.color,
                                                           options.sections ? "sections" : "strip", options.plan.cells);
    ProgressLine line(arguments.quiet);
    const auto done =
        run::draw_strip(arguments.what, options, [&](std::int64_t n, std::int64_t all) { line.frames(n, all); });
    line.end();
    return tell_drawn(done, {.folder = options.out, .video = {}}, settings, arguments);
}

int redraw_run(RenderArguments& arguments) {
    arguments.scene.file = arguments.what / "scene.toml";
    if (const auto found = run::find_run(arguments.what); !found)
        return refuse(found.problems(), arguments.json, wrong);
    if (const auto problems = refuse_sets_of_the_run(arguments.scene.sets, arguments.scene.file); !problems.empty())
        return refuse(problems, arguments.json, wrong);
    const Result<scene::Scene> scene = arguments.scene.load();
    if (!scene)
        return refuse(scene.problems(), arguments.json, wrong);
    for (const auto& problem :
         {refuse_ending(arguments, false), refuse_video(arguments.video), refuse_with_lines(arguments)})
        if (problem)
            return refuse({*problem}, arguments.json, wrong);
    const bool in_parts = !arguments.strip.empty() || !arguments.sections.empty();
    if (arguments.scene.flags.contains("render.plot_measure") && (in_parts || !arguments.beside.empty()) &&
        !arguments.quiet)
        note("warning: strips, sections and pairs have no small plot: --plot is left out; `tumble plot` draws one");
    if (const auto problem = refuse_with_one_file(arguments); problem && !in_parts)
        return refuse({*problem}, arguments.json, wrong);
    if (!arguments.beside.empty() && !in_parts)
        return draw_both(arguments, *scene);
    if (!arguments.labels.empty())
        return refuse({{.what = "--labels names two runs side by side, and this is one",
                        .fix = "add --beside OTHER, or leave --labels away"}},
                      arguments.json, wrong);
    run::RedrawOptions options;
    options.settings = scene->render;
    options.title = scene->title;
    for (const scene::Wall& wall : scene->walls)
        options.wall_opacity.push_back(wall.opacity);
    options.traced = run::traced_bodies(scene->observe.measures);
    options.overwrite = arguments.force;
    options.when.duration = scene->duration;
    options.when.stop = &watch_for_stop();
    const auto problem = read_time_range(arguments.time, options.when.from, options.when.to, arguments.what);
    if (problem)
        return refuse({*problem}, arguments.json, wrong);
    if (in_parts)
        return draw_parts(arguments, std::move(options));
    options.targets = targets_of(arguments, fmt::format("{}_{}", options.settings.camera, options.settings.color));
    ProgressLine line(arguments.quiet);
    const auto done =
        run::redraw(arguments.what, options, [&](std::int64_t n, std::int64_t all) { line.frames(n, all); });
    line.end();
    return tell_drawn(done, options.targets, options.settings, arguments);
}

int draw_scene(RenderArguments& arguments) {
    arguments.scene.file = arguments.what;
    const Result<scene::Scene> scene = arguments.scene.load();
    if (!scene)
        return refuse(scene.problems(), arguments.json, wrong);
    if (!arguments.beside.empty())
        return refuse({{.what = "--beside stands two runs side by side, and this is a scene",
                        .fix = "run it first, then give the run's folder"}},
                      arguments.json, wrong);
    if (!arguments.strip.empty() || !arguments.sections.empty())
        return refuse({{.what = "--strip and --sections draw a run that is over, and this is a scene",
                        .fix = "run it first, then give the run's folder"}},
                      arguments.json, wrong);
    if (render::is_drawing_file(arguments.out))
        return refuse({{.file = arguments.out.string(),
                        .what = "a drawing shows a run that is over, and this is a scene",
                        .fix = "run it first, then give the run's folder; --out names the run's folder here"}},
                      arguments.json, wrong);
    for (const auto& problem : {refuse_ending(arguments, true), refuse_video(arguments.video)})
        if (problem)
            return refuse({*problem}, arguments.json, wrong);
    if (!arguments.time.empty())
        return refuse({{.what = "--time chooses among the frames of a run, and this is a scene",
                        .fix = "run it first, then give the run's folder; or use --set duration_s=..."}},
                      arguments.json, wrong);
    run::RunOptions options;
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    options.folder = arguments.out;
    options.overwrite = arguments.force;
    options.pictures = arguments.frames || arguments.video.empty();
    options.video = !arguments.video.empty();
    options.video_file = arguments.video;
    options.stop = &watch_for_stop();
    ProgressLine line(arguments.quiet);
    const Result<run::RunSummary> summary = run::run_scene(*scene, options, line);
    line.end();
    if (!summary)
        return refuse(summary.problems(), arguments.json, wrong);
    return tell_outcome(*summary, arguments.json, arguments.quiet);
}

} // namespace

void add_render_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "render", "Example: tumble render out/drop --camera side --color speed --video drop.mp4\n\n"
                  "Draws the frames of a run again, with other colours and cameras, without simulating. Given a scene\n"
                  "instead of a run's folder it runs the scene first.");
    const auto arguments = std::make_shared<RenderArguments>();
    command->add_option("RUN|SCENE", arguments->what, "Folder of a run, or a scene file")->required();
    add_render_settings(*command, arguments->scene);
    command
        ->add_option("--beside", arguments->beside,
                     "A second run, drawn on the right at the same times with the same view and colours")
        ->type_name("RUN");
    command->add_option("--labels", arguments->labels, "What stands over the two, in place of their titles or folders")
        ->type_name("L,R");
    command->add_option("--video", arguments->video, "Make an MP4 (needs ffmpeg)")->type_name("F.mp4");
    command->add_flag("--frames", arguments->frames, "PNG files; the default without --video");
    command
        ->add_option("--strip", arguments->strip,
                     "N instants in one picture, evenly spaced, with their times; or columns and rows as 4x2")
        ->type_name("N");
    command
        ->add_option("--sections", arguments->sections,
                     "N cuts through the bodies at the last frame, across the way the camera looks, in one picture; or "
                     "their places along the camera's axis, m, such as 0,0.027,0.054")
        ->type_name("N|M,M,...");
    command
        ->add_option(
            "--out", arguments->out,
            "Folder for the PNG files, or for the run of a scene; of a strip or sections the picture where it "
            "ends in .png, else a folder with a picture each. A name that ends in .svg or .pdf: the last frame, "
            "the two runs or the strip drawn as lines (two dimensions)")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_option("--time", arguments->time, "Only frames from A to B, s; either may be missing")
        ->type_name("A:B");
    arguments->scene.add_sets_to(*command);
    command->add_flag("--force", arguments->force, "Replace what is there");
    command->add_flag("--quiet", arguments->quiet, "No progress, no warnings on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] {
        action = [arguments] {
            std::error_code ignored;
            const bool scene =
                ending_of(arguments->what) == ".toml" && !std::filesystem::is_directory(arguments->what, ignored);
            return scene ? draw_scene(*arguments) : redraw_run(*arguments);
        };
    });
}

} // namespace tumble::cli
