#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/progress_line.h"
#include "cli/run_outcome.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "run/run_scene.h"

#include <memory>
#include <thread>

namespace tumble::cli {

namespace {

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
        "with the outputs it had. Begins where there is none");
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
        ->check(CLI::Range(0.0, 1e6));
}

int run_it(RunArguments& arguments) {
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
        ->check(refuse_dash);
    command->add_flag("--frames", options.pictures, "Draw every frame as PNG, in pictures/");
    command->add_flag("--video", options.video, "Make video.mp4 of all frames (needs ffmpeg)");
    command->add_flag("--vtk", options.paraview, "Write VTP and PVD files for ParaView, in paraview/");
    command->add_flag("--dump", options.text_dump, "Write all spheres as LIGGGHTS-style text for OVITO, spheres.dump");
    command->add_option("--threads", options.threads, "Threads that step; changes the time taken, never the result")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    CLI::Option* force = command->add_flag("--force", options.overwrite, "Replace an earlier run in the folder");
    add_resume_flags(*command, options, *force);
    command->add_flag("--quiet", arguments->quiet, "No progress, no warnings on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON (the content of run.json)");
    command->callback([arguments, &action] { action = [arguments] { return run_it(*arguments); }; });
}

} // namespace tumble::cli
