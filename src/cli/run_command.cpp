#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/run_outcome.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "run/run_folder.h"
#include "run/run_scene.h"

#include <fmt/format.h>
#include <memory>
#include <thread>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
    SceneArguments scene;
    run::RunOptions options;
    bool quiet = false;
    bool json = false;
};

void add_resume_flags(CLI::App& command, run::RunOptions& options, CLI::Option& force) {
    CLI::Option* resume = command.add_flag(
        "--resume", options.resume,
        "Go on where a run in the folder ended (Ctrl-C, a kill, its duration), by the bits of a run that never did; "
        "with the outputs it had. Begins where there is none. In place of SCENE the run's folder may stand");
    resume->excludes(&force);
    command
        .add_flag("--accept-changes", options.accept_changes,
                  "Go on although the scene's materials, laws, gravity or motions were changed since")
        ->needs(resume);
    command
        .add_option(
            "--checkpoint-every", options.checkpoint_every,
            "Wall time between checkpoints in state/, which --resume needs; 0: none; 60 without it. Box2D has none")
        ->type_name("S")
        ->check(number_from(0.0, 1e6));
}

/// A run's own folder in place of a scene: with --resume the run goes on there.
std::optional<Problem> take_folder(RunArguments& arguments) {
    const fs::path folder = arguments.scene.file;
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored) || !run::find_run(folder))
        return std::nullopt;
    const std::string scene = (folder / "scene.toml").string();
    if (!arguments.options.resume)
        return Problem{.file = folder.string(),
                       .what = "is the folder of a run, not a scene file",
                       .fix = fmt::format("`tumble run {} --resume` goes on with the run; `tumble run {} --out DIR` "
                                          "runs its scene again elsewhere",
                                          folder.string(), scene)};
    const fs::path& out = arguments.options.folder;
    if (!out.empty() && !fs::equivalent(out, folder, ignored))
        return Problem{
            .file = folder.string(),
            .what = "a run goes on in its own folder, and --out names another place",
            .fix = fmt::format("leave out --out; `tumble run {} --out DIR` runs its scene again elsewhere", scene)};
    arguments.scene.file = scene;
    arguments.options.folder = folder;
    return std::nullopt;
}

int run_it(RunArguments& arguments) {
    if (const auto problem = take_folder(arguments))
        return refuse({*problem}, arguments.json, wrong);
    const Result<scene::Scene> scene = arguments.scene.load();
    if (!scene)
        return refuse(scene.problems(), arguments.json, wrong);
    arguments.options.stop = &watch_for_stop();
    ProgressLine line(arguments.quiet);
    const Result<run::RunSummary> summary = run::run_scene(*scene, arguments.options, line);
    line.end();
    if (!summary)
        return refuse(summary.problems(), arguments.json, stop_wanted(arguments.options.stop) ? stop_code() : wrong);
    return tell_outcome(*summary, arguments.json, arguments.quiet);
}

} // namespace

void add_run_command(CLI::App& program, Action& action) {
    CLI::App* command =
        program.add_subcommand("run", "Example: tumble run scenes/drop.toml --frames --set duration_s=0.1\n\n"
                                      "Runs a scene and leaves all of it in a folder, out/drop here.");
    const auto arguments = std::make_shared<RunArguments>();
    run::RunOptions& options = arguments->options;
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    arguments->scene.add_to(*command);
    command->add_option("--out", options.folder, "Folder for the run; out/NAME of the scene file without it")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_flag("--frames", options.pictures, "Draw every frame as PNG, in pictures/");
    command->add_flag("--video", options.video, "Make video.mp4 of all frames (needs ffmpeg)");
    command->add_flag("--vtk", options.paraview, "Write VTP and PVD files for ParaView, in paraview/");
    command->add_flag("--dump", options.text_dump, "Write all spheres as LIGGGHTS-style text for OVITO, spheres.dump");
    command->add_option("--threads", options.threads, "Threads that step; changes the time taken, never the result")
        ->type_name("N")
        ->check(whole_number_from(1, 256));
    CLI::Option* force = command->add_flag("--force", options.overwrite, "Replace an earlier run in the folder");
    add_resume_flags(*command, options, *force);
    command->add_flag("--quiet", arguments->quiet, "No progress, no warnings on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON (the content of run.json)");
    command->callback([arguments, &action] { action = [arguments] { return run_it(*arguments); }; });
}

} // namespace tumble::cli
