#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/patch_flag.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "cli/time_range.h"
#include "observe/whole_file.h"
#include "run/redraw.h"
#include "stress/recorded.h"
#include "stress/study.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

struct ExportArguments {
    std::filesystem::path run;
    run::ExportOptions options;
    std::string to;                       // "calculix", or empty
    std::string element = "incompatible"; // as `stress` solves it
    std::string part;
    std::filesystem::path out;
    bool means = false;
    double patch = 1;
    std::string time;
    bool quiet = false;
    bool json = false;
};

/// The model of a folder that `tumble stress` left, with its load steps.
int export_model(const ExportArguments& arguments) {
    auto recorded = stress::read_recorded(arguments.run, arguments.part);
    if (!recorded)
        return refuse(recorded.problems(), arguments.json, wrong);
    run::ReplayOptions when;
    if (const auto problem = read_time_range(arguments.time, when.from, when.to))
        return refuse({*problem}, arguments.json, wrong);
    stress::keep_within(recorded->loads, when.from, when.to);
    if (arguments.means ? recorded->loads.means.empty() : recorded->loads.instants.empty())
        return refuse({{.file = arguments.run.string(),
                        .what = fmt::format("has no load case within '{}'", arguments.time),
                        .fix = "its times stand in contacts.csv and means.csv"}},
                      arguments.json, wrong);
    Crew crew(1);
    const auto cases =
        stress::nodal_cases(recorded->specimen(), recorded->loads, arguments.means, arguments.patch, crew);
    if (!cases)
        return refuse(cases.problems(), arguments.json, failed);
    const std::filesystem::path file = arguments.out.empty() ? arguments.run / "part.inp" : arguments.out;
    if (!arguments.options.overwrite)
        if (const auto problem = refuse_to_overwrite({file}))
            return refuse({*problem}, arguments.json, wrong);
    const auto formulation =
        arguments.element == "standard" ? fem::Formulation::standard : fem::Formulation::incompatible;
    const std::string text = stress::to_calculix(*recorded, *cases, formulation, arguments.means);
    if (const auto written = observe::write_whole(file, text); !written)
        return refuse(written.problems(), arguments.json, failed);
    if (arguments.json)
        say_json(nlohmann::ordered_json{{"file", file.string()}, {"steps", cases->size()}});
    else if (!arguments.quiet)
        say(fmt::format("{}: {} hexahedra, {}", file.string(), recorded->specimen().mesh->hexes.size(),
                        counted(static_cast<long long>(cases->size()), "load step", "load steps")));
    return fine;
}

int export_it(ExportArguments& arguments) {
    if (!arguments.to.empty())
        return export_model(arguments);
    run::ExportOptions& options = arguments.options;
    if (options.paraview.empty() && options.text_dump.empty())
        return refuse(
            {{.what = "nothing to export to", .fix = "give --vtk DIR, --dump FILE or both, or --to calculix"}},
            arguments.json, wrong);
    if (const auto problem = read_time_range(arguments.time, options.when.from, options.when.to, arguments.run))
        return refuse({*problem}, arguments.json, wrong);
    options.when.stop = &watch_for_stop();
    ProgressLine line(arguments.quiet);
    const auto done =
        run::export_run(arguments.run, options, [&](std::int64_t n, std::int64_t all) { line.frames(n, all); });
    line.end();
    if (!done)
        return refuse(done.problems(), arguments.json, wrong);
    if (!done->reason.empty())
        return refuse(done->reason, arguments.json, failed);
    for (const std::string& warning : done->warnings)
        if (!arguments.quiet)
            note("warning: " + warning);
    if (arguments.json)
        say_json(nlohmann::ordered_json{{"frames", done->frames},
                                        {"first_s", done->first},
                                        {"last_s", done->last},
                                        {"stopped", done->stopped},
                                        {"vtk", options.paraview.string()},
                                        {"dump", options.text_dump.string()},
                                        {"warnings", done->warnings}});
    else if (!arguments.quiet)
        say(fmt::format("{} from t = {:.4g} to {:.4g} s", counted(done->frames, "frame", "frames"), done->first,
                        done->last));
    return done->stopped ? stop_code() : static_cast<int>(fine);
}

} // namespace

void add_export_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("export", "Example: tumble export out/drop --vtk drop-paraview\n\n"
                                                         "Writes the frames of a run for other tools.");
    const auto arguments = std::make_shared<ExportArguments>();
    command->add_option("RUN", arguments->run, "Folder of a run")->required();
    command->add_option("--vtk", arguments->options.paraview, "Folder for ParaView's VTP and PVD files")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_option("--dump", arguments->options.text_dump, "LIGGGHTS-style text file of all spheres")
        ->type_name("FILE")
        ->check(refuse_no_place);
    command
        ->add_option("--to", arguments->to, "calculix: the part of a folder that `tumble stress` left, with load steps")
        ->type_name("PROGRAM")
        ->check(one_of({"calculix"}));
    command->add_option("--out", arguments->out, "The file of --to; part.inp in the folder without it")
        ->type_name("FILE")
        ->check(refuse_no_place);
    command
        ->add_option("--element", arguments->element,
                     "incompatible (C3D8I) or standard (C3D8); incompatible without it, as stress")
        ->type_name("NAME")
        ->check(one_of({"incompatible", "standard"}));
    command->add_flag("--means", arguments->means, "Steps are the means between instants instead of the instants");
    add_patch_flag(*command, arguments->patch);
    command->add_option("--part", arguments->part, "The specimen, where the scene has several")->type_name("WALL");
    command->add_option("--time", arguments->time, "Only frames from A to B, s; either may be missing")
        ->type_name("A:B");
    command->add_flag("--force", arguments->options.overwrite, "Replace what is there");
    command->add_flag("--quiet", arguments->quiet, "No progress, no warnings on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return export_it(*arguments); }; });
}

} // namespace tumble::cli
