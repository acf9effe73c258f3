#include "base/make_folder.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/patch_flag.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "cli/sheet_flags.h"
#include "cli/stop_flag.h"
#include "fem/component.h"
#include "observe/whole_file.h"
#include "run/checkpoint_files.h"
#include "run/part_loads.h"
#include "run/run_folder.h"
#include "sheet/show.h"
#include "stress/pictures.h"
#include "stress/recorded.h"
#include "stress/study.h"
#include "stress/study_sheet.h"
#include "stress/trim.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <optional>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;

struct StressArguments {
    SceneArguments scene;
    std::string part;
    std::string element = "incompatible";
    std::vector<double> depths_mm;
    double edge_mm = 3;
    std::vector<std::string> remesh;
    run::LoadOptions loads;
    stress::StudyOptions study;
    stress::PictureOptions pictures;
    bool draw = false;
    double until = std::numeric_limits<double>::infinity(); // s, of a folder
    fs::path out;
    bool force = false;
    bool quiet = false;
    bool json = false;
    std::string of_runs; // the first flag given that only a run heeds
};

/// Whether a folder is solved again in its own place.
bool in_place(const StressArguments& arguments) {
    std::error_code ignored;
    return fs::equivalent(arguments.out, arguments.scene.file, ignored);
}

/// What a folder with loads cannot be asked for.
std::optional<Problem> refuse_again(const StressArguments& arguments) {
    const std::string folder = arguments.scene.file.string();
    if (!arguments.scene.sets.empty())
        return Problem{.file = folder,
                       .what = "is solved again as it was run: --set and --duration change nothing there",
                       .fix = "give them with the scene file"};
    if (!arguments.of_runs.empty())
        return Problem{.file = folder,
                       .what =
                           fmt::format("is solved again as it was run: {} changes nothing there", arguments.of_runs),
                       .fix = "give it with the scene file, which runs it again"};
    for (const std::string& set : arguments.remesh)
        if (set.find('=') == std::string::npos || set.find('=') == 0)
            return Problem{.file = "--remesh " + set,
                           .what = "is not KEY=VALUE",
                           .fix = "write --remesh KEY=VALUE, for example --remesh around=120"};
    const bool itself = in_place(arguments);
    std::error_code ignored;
    if (arguments.force || (itself && arguments.remesh.empty()) || !fs::exists(arguments.out / "cases.csv", ignored))
        return std::nullopt;
    return Problem{.file = arguments.out.string(),
                   .what =
                       itself ? "holds the stresses of the mesh that was run" : "holds the stresses of another study",
                   .fix = "give another folder: --out; --force replaces them"};
}

/// A folder solved again in its own place: other settings would replace what may be of use beside them.
std::optional<Problem> refuse_other(const StressArguments& arguments, const std::string& settings) {
    std::error_code ignored;
    if (arguments.force || !fs::exists(arguments.out / "cases.csv", ignored))
        return std::nullopt;
    const std::string kept = stress::kept_settings(arguments.out);
    if (kept == settings)
        return std::nullopt;
    return Problem{.file = arguments.out.string(),
                   .what = kept.empty()
                               ? "holds stresses that were solved before settings were kept beside them"
                               : "holds stresses that were solved otherwise: " + stress::what_differs(kept, settings),
                   .fix = "--out DIR keeps both; --force replaces them"};
}

/// Says which stresses of the folder give way.
void tell_replaced(const fs::path& folder, const std::string& settings) {
    std::error_code ignored;
    if (!fs::exists(folder / "cases.csv", ignored))
        return;
    const std::string kept = stress::kept_settings(folder);
    note(fmt::format("replaces the stresses in {}: {}", folder.string(),
                     kept == settings ? "solved again with the same settings"
                     : kept.empty()   ? "solved before settings were kept"
                                      : stress::what_differs(kept, settings)));
}

/// A file for --remesh lies where the command is given, as all that it names; a scene's lies beside the scene.
std::string with_place(const std::string& set) {
    const auto equals = set.find('=');
    if (trimmed(set.substr(0, equals)) != "inp")
        return set;
    std::string file(trimmed(set.substr(equals + 1)));
    if (file.size() > 1 && (file.front() == '"' || file.front() == '\'') && file.back() == file.front())
        file = file.substr(1, file.size() - 2);
    return "inp='" + fs::absolute(file).lexically_normal().string() + "'";
}

/// What the scene says of --set is said of --remesh.
Problems of_remesh(Problems problems, const StressArguments& arguments) {
    const auto recorded = stress::read_recorded(arguments.scene.file, arguments.part);
    if (!recorded)
        return problems;
    const std::string set = "--set wall." + recorded->name() + ".";
    for (Problem& problem : problems)
        for (std::string* words : {&problem.file, &problem.what, &problem.fix})
            for (auto at = words->find(set); at != std::string::npos; at = words->find(set))
                words->replace(at, set.size(), "--remesh ");
    return problems;
}

/// What a folder holds, on its mesh or another, from --from to --until.
Result<stress::Recorded> again_from(const StressArguments& arguments) {
    std::vector<std::string> sets;
    for (const std::string& set : arguments.remesh)
        sets.push_back(with_place(set));
    auto recorded = sets.empty() ? stress::read_recorded(arguments.scene.file, arguments.part)
                                 : stress::read_remeshed(arguments.scene.file, arguments.part, sets);
    if (!recorded)
        return sets.empty() ? recorded.problems() : of_remesh(recorded.problems(), arguments);
    if (recorded->loads.stopped)
        note(fmt::format(
            "warning: the run in {} was stopped at {:.6g} s of {:.6g} s; these are the stresses up to there. "
            "`tumble stress SCENE --out {} --resume` goes on",
            arguments.scene.file.string(), recorded->loads.instants.back().time, recorded->scene.duration,
            arguments.scene.file.string()));
    if (const auto slices = stress::slices_of(recorded->specimen(), arguments.study); !slices)
        return slices.problems();
    if (const auto left = stress::trim(*recorded, arguments.loads.from, arguments.until); !left)
        return left.problems();
    return recorded;
}

/// settings_of, and what else tells two studies of a run apart: between which times, and, elsewhere, of which run.
std::string settings_with(const StressArguments& arguments, const stress::Recorded& recorded, bool again) {
    std::string text = stress::settings_of(recorded.specimen(), arguments.study);
    if (again && !in_place(arguments))
        text += fmt::format("run = {}\n",
                            fs::proximate(fs::absolute(arguments.scene.file), fs::absolute(arguments.out)).string());
    for (const std::string& set : arguments.remesh)
        text += fmt::format("remesh = {}\n", set);
    if (again && arguments.loads.from > 0)
        text += fmt::format("from_s = {:.9g}\n", arguments.loads.from);
    if (std::isfinite(arguments.until))
        text += fmt::format("until_s = {:.9g}\n", arguments.until);
    return text;
}

/// A folder that is there, held against other runs.
Result<run::FolderInWork> held(const fs::path& folder) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    return run::FolderInWork::go_on(folder);
}

/// The folder that a run is to fill.
Result<run::FolderInWork> folder_of_run(const StressArguments& arguments) {
    const fs::path& out = arguments.out;
    const bool begun = stress::holds_begun(out), loads = stress::holds_loads(out),
               checkpoints = !run::list_checkpoints(run::RunFolder{out}.checkpoints()).empty();
    if (arguments.loads.resume && loads && !checkpoints)
        return Problem{.file = out.string(),
                       .what = "holds the loads of an earlier run, and no checkpoint to go on from",
                       .fix = "--force runs the scene again and replaces them"};
    // It begins where there is none, beside whatever else lies there, but for a folder of `tumble run`.
    if (std::error_code ignored;
        arguments.loads.resume && fs::exists(out, ignored) && !fs::exists(run::RunFolder{out}.summary(), ignored))
        return held(out);
    if (arguments.force || !(begun || loads || checkpoints))
        return run::FolderInWork::open(out, arguments.force, 0);
    if (auto idle = held(out); !idle) // a run goes on in it
        return idle;
    if (loads)
        return Problem{.file = out.string(),
                       .what = "holds the loads of an earlier run",
                       .fix = fmt::format("`tumble stress {}` solves them again, --force replaces them", out.string())};
    return Problem{.file = out.string(),
                   .what = "holds a run that was killed before it came to its loads",
                   .fix = "the same command with --resume goes on with it, with --force replaces it, with --out DIR "
                          "writes elsewhere"};
}

/// Runs the scene and keeps its loads; `folder` holds the place until their stresses are there, too.
Result<stress::Recorded> simulated(StressArguments& arguments, std::optional<run::FolderInWork>& folder) {
    auto scene = arguments.scene.load();
    if (!scene)
        return scene.problems();
    auto recorded = stress::specimen_in(std::move(*scene), arguments.part);
    if (!recorded)
        return recorded;
    if (const auto slices = stress::slices_of(recorded->specimen(), arguments.study); !slices)
        return slices.problems(); // before the run, not behind it
    auto taken = folder_of_run(arguments);
    if (!taken)
        return taken.problems();
    folder.emplace(std::move(*taken));
    arguments.loads.threads = arguments.study.threads;
    arguments.loads.stop = &watch_for_stop();
    arguments.loads.folder = arguments.out;
    arguments.loads.begun = [&]() -> Result<Done> {
        folder->keep();
        if (!arguments.loads.resume)
            run::remove_loads(arguments.out);
        return stress::write_what_runs(*recorded, arguments.out);
    };
    ProgressLine line(arguments.quiet);
    auto loads = run::record_loads(recorded->scene, recorded->wall, arguments.loads, line);
    line.end();
    if (!loads)
        return loads.problems();
    recorded->loads = std::move(*loads);
    recorded->frames = arguments.out / "frames";
    if (const auto written = stress::write_recorded(*recorded, arguments.out); !written)
        return written.problems();
    return recorded;
}

/// What is asked for, in SI.
void take_up(StressArguments& arguments, bool again) {
    arguments.study.formulation =
        arguments.element == "standard" ? fem::Formulation::standard : fem::Formulation::incompatible;
    if (!arguments.depths_mm.empty())
        arguments.study.depths.clear();
    for (const double depth : arguments.depths_mm)
        arguments.study.depths.push_back(1e-3 * depth);
    arguments.study.counting.edge = 1e-3 * arguments.edge_mm;
    if (arguments.out.empty())
        arguments.out =
            again ? arguments.scene.file : fs::path("out") / (arguments.scene.file.stem().string() + "-stress");
}

/// What only a folder with loads can be asked for.
std::optional<Problem> refuse_of_folders(const StressArguments& arguments) {
    const std::string file = arguments.scene.file.string();
    if (!arguments.remesh.empty())
        return Problem{.file = file,
                       .what = "--remesh is for a folder with loads",
                       .fix = "choose the mesh by --set wall.NAME.KEY=VALUE"};
    if (std::isfinite(arguments.until))
        return Problem{
            .file = file, .what = "--until is for a folder with loads", .fix = "--duration ends the run of a scene"};
    return std::nullopt;
}

/// The files of the study and its pictures; the report among them.
Result<std::vector<fs::path>> keep_study(const StressArguments& arguments, const stress::Recorded& recorded,
                                         const stress::Study& study, const std::string& report) {
    auto files = stress::write_study(study, recorded.specimen(), recorded.loads, arguments.out);
    if (!files)
        return files;
    files->push_back(arguments.out / "report.txt");
    if (const auto kept = observe::write_whole(files->back(), report); !kept)
        return kept.problems();
    if (!arguments.draw)
        return files;
    const auto pictures = stress::draw_pictures(recorded, study, arguments.pictures, arguments.out);
    if (!pictures)
        return pictures.problems();
    files->insert(files->end(), pictures->begin(), pictures->end());
    return files;
}

int solve_it(StressArguments& arguments) {
    const bool again = fs::is_directory(arguments.scene.file);
    take_up(arguments, again);
    if (const auto problem = again ? refuse_again(arguments) : refuse_of_folders(arguments))
        return refuse({*problem}, arguments.json, wrong);
    std::optional<run::FolderInWork> folder;
    if (again && in_place(arguments)) { // before it is read: a run may be going on in it
        auto taken = held(arguments.out);
        if (!taken)
            return refuse(taken.problems(), arguments.json, wrong);
        folder.emplace(std::move(*taken));
    }
    const auto recorded = again ? again_from(arguments) : simulated(arguments, folder);
    if (!recorded)
        return refuse(recorded.problems(), arguments.json, wrong);
    const std::string settings = settings_with(arguments, *recorded, again);
    if (again)
        if (const auto problem = refuse_other(arguments, settings))
            return refuse({*problem}, arguments.json, wrong);
    if (!folder) {
        auto taken = held(arguments.out);
        if (!taken)
            return refuse(taken.problems(), arguments.json, wrong);
        folder.emplace(std::move(*taken));
    }
    auto study = stress::study(recorded->scene, recorded->specimen(), recorded->loads, arguments.study);
    if (!study)
        return refuse(study.problems(), arguments.json, failed);
    study->settings = settings;
    tell_replaced(arguments.out, settings);
    const sheet::Sheet sheet = stress::sheet_of(*study, arguments.study);
    const std::string report = sheet::to_text(recorded->scene.title + ": stress inside " + recorded->name(), sheet);
    const auto files = keep_study(arguments, *recorded, *study, report);
    if (!files)
        return refuse(files.problems(), arguments.json, failed);
    if (arguments.json)
        say_json(sheet::to_json(sheet));
    else
        say(report);
    for (const std::string& doubt : study->doubts)
        if (!arguments.quiet)
            note("warning: " + doubt);
    if (const int code = draw_and_note(sheet, arguments.out, arguments.json); code != fine)
        return code;
    if (!arguments.quiet)
        for (const fs::path& file : *files)
            note("file: " + file.string());
    if (again || !recorded->loads.stopped)
        return fine;
    note("warning: stopped early; these are the stresses up to there. The same command with --resume goes on");
    return stop_code();
}

} // namespace

void add_stress_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "stress",
        "Example: tumble stress scenes/specimen-quick.toml --threads 2\n\n"
        "Runs a scene with a specimen, turns what touches it into nodal loads and solves the stress inside,\n"
        "one load case an instant; all that was recorded is kept, and the folder can be given in the scene's\n"
        "place to solve it again otherwise. docs/stress.md.");
    const auto arguments = std::make_shared<StressArguments>();
    stress::StudyOptions& study = arguments->study;
    arguments->scene.add_to(*command);
    command->add_option("--part", arguments->part, "The specimen, where the scene has several")->type_name("WALL");
    command
        ->add_option("--element", arguments->element,
                     "incompatible (bends right) or standard (the thesis' C3D8); incompatible without it")
        ->type_name("NAME")
        ->check(one_of({"incompatible", "standard"}));
    command
        ->add_option("--depth", arguments->depths_mm,
                     "Slices beneath the surface, mm; 0.5,1,1.5 without it, as the thesis")
        ->type_name("A,B")
        ->delimiter(',')
        ->check(number_from(0, 1e6));
    command->add_option("--side", study.sides, "Only beneath this side of the part, or end of it; may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    command
        ->add_option("--lower", study.counting.lower,
                     "Only this share of the part's length, from its lower end, counts in slices; 1 without it, the "
                     "thesis has 0.5")
        ->type_name("X")
        ->check(number_from(0, 1));
    command
        ->add_option("--edge", arguments->edge_mm,
                     "What is near an edge: so far from where a side ends, mm; 3 without it")
        ->type_name("MM")
        ->check(number_from(0, 1e6));
    command
        ->add_option("--remesh", arguments->remesh,
                     "With a folder: key of the specimen and a value, as around=120 or inp=finer.inp; the same "
                     "contacts on another mesh; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command->add_flag("--means", study.means, "Solve the mean loads between the instants instead of the instants");
    add_patch_flag(*command, study.patch);
    command->add_flag("--pictures", arguments->draw,
                      "Draw the worst case: the part among the media, cuts through it, its slices rolled out");
    command
        ->add_option("--show", arguments->pictures.component,
                     "Stress on surface and cuts of the pictures; von_mises without it")
        ->type_name("NAME")
        ->check(one_of(fem::component_names()));
    command
        ->add_option("--veil", arguments->pictures.veil,
                     "Opacity of the media before the part in its picture; 0.2 without it, 0: none")
        ->type_name("X")
        ->check(number_from(0, 1));
    command->add_option("--every", arguments->loads.every, "s between instants; 1/60 without it, as the thesis")
        ->type_name("S")
        ->check(number_above_zero());
    command
        ->add_option("--from", arguments->loads.from,
                     "s, nothing before counts; of a folder, what it holds of later times is solved again")
        ->type_name("S")
        ->check(number_from(0, 1e9));
    command->add_option("--until", arguments->until, "With a folder: s, nothing after counts")
        ->type_name("S")
        ->check(number_from(0, 1e9));
    command->add_option("--threads", study.threads, "Threads that step and solve; 1 without it")
        ->type_name("N")
        ->check(whole_number_from(1, 256));
    command->add_option("--out", arguments->out, "Folder; out/NAME-stress of the scene file without it")
        ->type_name("DIR")
        ->check(refuse_no_place);
    CLI::Option* force = command->add_flag("--force", arguments->force,
                                           "Replace the loads of an earlier run, or the stresses of another study");
    command
        ->add_flag("--resume", arguments->loads.resume,
                   "Go on where a run in the folder was stopped or killed, to the same bits; begin where there is none")
        ->excludes(force);
    command
        ->add_option("--checkpoint-every", arguments->loads.checkpoint_every,
                     "Wall time between checkpoints in state/, which --resume needs; 0: none; 60 without it")
        ->type_name("S")
        ->check(number_from(0, 1e9));
    command->add_flag("--quiet", arguments->quiet, "No progress on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, command, &action] {
        for (const char* flag : {"--every", "--resume", "--checkpoint-every"})
            if (arguments->of_runs.empty() && command->count(flag) > 0)
                arguments->of_runs = flag;
        action = [arguments] { return solve_it(*arguments); };
    });
}

} // namespace tumble::cli
