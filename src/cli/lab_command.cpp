#include "cli/canvas_flags.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/sheet_flags.h"
#include "lab/experiment.h"
#include "observe/whole_file.h"
#include "scene/read_file.h"
#include "sheet/show.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;
using lab::Experiment;

struct LabArguments {
    std::string unknown; // a first word that is no experiment
    bool json = false;
};

struct ExperimentArguments {
    sheet::Typed typed;
    fs::path folder, record;
    CanvasFlags canvas;
    bool json = false;
};

int write_recordings(const lab::Outcome& outcome, const fs::path& folder, bool json) {
    for (const lab::Recording& recording : outcome.recordings) {
        const fs::path file = folder / (recording.name + ".csv");
        if (const auto written = observe::write_whole(file, recording.csv()); !written)
            return refuse(written.problems(), json, failed);
        note("record: " + file.string());
    }
    return fine;
}

Result<lab::Outcome> evaluate(const Experiment& experiment, const fs::path& record, const sheet::Values& values) {
    Result<std::string> text = scene::read_file(record, TableLimits{}.bytes);
    if (!text)
        return text.problems();
    const Result<Table> read = parse_table(std::move(*text), record.string());
    return read ? experiment.evaluate(*read, values) : read.problems();
}

int perform(const Experiment& experiment, const ExperimentArguments& arguments) {
    const Result<sheet::Values> values = lab::read_values(experiment, arguments.typed);
    const auto canvas = canvas_of(arguments.canvas);
    if (!values || !canvas)
        return refuse(values ? canvas.problems() : values.problems(), arguments.json, wrong);
    const Result<lab::Outcome> outcome =
        arguments.record.empty() ? experiment.perform(*values) : evaluate(experiment, arguments.record, *values);
    if (!outcome)
        return refuse(outcome.problems(), arguments.json, wrong);
    if (!arguments.folder.empty()) {
        if (const int code = draw_and_note(outcome->sheet, arguments.folder, arguments.json, *canvas); code != fine)
            return code;
        if (const int code = write_recordings(*outcome, arguments.folder, arguments.json); code != fine)
            return code;
    }
    if (arguments.json) {
        nlohmann::ordered_json json{
            {"experiment", experiment.name}, {"title", experiment.title}, {"parameters", values->all()}};
        json.update(sheet::to_json(outcome->sheet));
        say_json(json);
        return fine;
    }
    sheet::Sheet all = outcome->sheet;
    if (!experiment.parameters.empty())
        all.parts.insert(all.parts.begin(), sheet::grid_of(experiment.parameters, *values));
    say(sheet::to_text(experiment.title, all));
    return fine;
}

int list_experiments(const LabArguments& arguments) {
    if (!arguments.unknown.empty())
        return refuse(lab::find_experiment(arguments.unknown).problems(), arguments.json, wrong);
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows;
    for (const Experiment& experiment : lab::all_experiments()) {
        items.push_back({{"name", experiment.name}, {"title", experiment.title}});
        rows.push_back({experiment.name, experiment.title});
    }
    if (arguments.json)
        say_json(items);
    else
        say(table(rows));
    return fine;
}

void add_experiment(CLI::App& all, const Experiment& experiment, Action& action) {
    CLI::App* command = all.add_subcommand(
        experiment.name, fmt::format("Example: tumble lab {}{} --out measured\n\n{}.", experiment.name,
                                     example_of(experiment.parameters), experiment.title));
    const auto arguments = std::make_shared<ExperimentArguments>();
    add_parameters(*command, experiment.parameters, arguments->typed);
    if (experiment.evaluate)
        command
            ->add_option("--record", arguments->record,
                         "Evaluate this record (" + experiment.record_form + ") instead of running the experiment")
            ->type_name("FILE.csv");
    command
        ->add_option("--out", arguments->folder,
                     "Folder for the records as CSV and the figures as PNG and SVG (needs gnuplot)")
        ->type_name("DIR")
        ->check(refuse_no_place);
    add_canvas_flags(*command, arguments->canvas);
    command->add_flag("--json", arguments->json, "Print the result as JSON: facts, tables, curves");
    command->callback([arguments, &experiment, &action] {
        action = [arguments, &experiment] { return perform(experiment, *arguments); };
    });
}

} // namespace

void add_lab_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "lab", "Example: tumble lab drop --heights 3 --out measured\n\n"
               "Experiments that find a material's numbers, run by the solvers, with the closed form\n"
               "beside; their records can serve as measured data. Without a name: lists them.");
    const auto arguments = std::make_shared<LabArguments>();
    command->require_subcommand(0, 1);
    // Experiments are subcommands; only a word that is none of them ends here.
    command->add_option("NAME", arguments->unknown, "The experiment; `tumble lab NAME --help` shows its parameters");
    command->add_flag("--json", arguments->json, "Print the list as JSON");
    command->callback([command, arguments, &action] {
        if (command->get_subcommands().empty())
            action = [arguments] { return list_experiments(*arguments); };
    });
    for (const Experiment& experiment : lab::all_experiments())
        add_experiment(*command, experiment, action);
}

} // namespace tumble::cli
