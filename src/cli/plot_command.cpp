#include "base/growing_file.h"
#include "base/make_folder.h"
#include "base/text.h"
#include "cli/canvas_flags.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/time_range.h"
#include "run/series_plot.h"
#include "run/target.h"
#include "sheet/gnuplot.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

struct PlotArguments {
    std::vector<std::filesystem::path> runs;
    std::vector<std::string> measures;
    std::string labels;
    std::string time;
    std::filesystem::path out;
    CanvasFlags canvas;
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// Without a size as high as its panels are to be.
Result<sheet::Canvas> canvas_for(const PlotArguments& arguments, sheet::Stack& stack) {
    auto canvas = canvas_of(arguments.canvas);
    if (!canvas)
        return canvas;
    if (!canvas->titled)
        stack.title.clear();
    if (arguments.canvas.size.empty())
        canvas->height_mm = sheet::usual_height(stack, *canvas);
    if (auto problem = refuse_pixels(*canvas))
        return *problem;
    return canvas;
}

nlohmann::ordered_json json_of(const run::SeriesPlot& plot, const std::filesystem::path& file,
                               const sheet::Canvas& canvas) {
    nlohmann::ordered_json panels = nlohmann::ordered_json::array();
    for (std::size_t p = 0; p < plot.columns.size(); ++p)
        panels.push_back({{"unit", plot.stack.panels[p].y.unit}, {"columns", plot.columns[p]}});
    return {{"file", file.string()},    {"width_mm", canvas.width_mm}, {"height_mm", canvas.height_mm},
            {"first_s", plot.first},    {"last_s", plot.last},         {"panels", panels},
            {"warnings", plot.warnings}};
}

Result<run::SeriesPlot> read_plot(const PlotArguments& arguments) {
    run::SeriesPlotOptions options;
    options.measures = arguments.measures;
    if (const auto problem = read_time_range(arguments.time, options.from, options.to, arguments.runs.front()))
        return *problem;
    if (!arguments.labels.empty())
        for (const std::string_view label : split(arguments.labels, ','))
            options.labels.emplace_back(trimmed(label));
    return run::plot_series(arguments.runs, options);
}

int plot_runs(const PlotArguments& arguments) {
    const auto refused = [&](const Problems& problems, int code = wrong) {
        return refuse(problems, arguments.json, code);
    };
    const std::filesystem::path file =
        arguments.out.empty() ? arguments.runs.front() / "redrawn" / "plot.png" : arguments.out;
    if (const auto known = sheet::check_drawable(file); !known)
        return refused(known.problems());
    auto plot = read_plot(arguments);
    if (!plot)
        return refused(plot.problems());
    const auto canvas = canvas_for(arguments, plot->stack);
    if (!canvas)
        return refused(canvas.problems());
    if (const auto script = sheet::gnuplot_script(plot->stack, file, *canvas); !script) // no room on that canvas
        return refused(script.problems());
    run::Target target(file);
    if (const auto problem = target.claim(arguments.force, file.extension().string()))
        return refused({*problem});
    if (const auto made = make_folder(std::filesystem::absolute(file).parent_path()); !made)
        return refused(made.problems());
    if (const auto place = check_writable(file); !place)
        return refused(place.problems());
    if (const auto drawn = sheet::draw(plot->stack, file, *canvas); !drawn)
        return refused(drawn.problems(), failed);
    target.keep();
    for (const std::string& warning : plot->warnings)
        if (!arguments.quiet)
            note("warning: " + warning);
    if (arguments.json)
        say_json(json_of(*plot, file, *canvas));
    else if (!arguments.quiet)
        say(fmt::format("{}: {} from t = {:.4g} to {:.4g} s", file.string(),
                        counted(static_cast<long long>(plot->columns.size()), "plot", "plots"), plot->first,
                        plot->last));
    return fine;
}

} // namespace

void add_plot_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "plot", "Example: tumble plot out/drop --measure kinetic_energy,centre_of_mass_y\n\n"
                "Plots what a run measured over time, a panel for each unit. Several runs lie over each other.");
    const auto arguments = std::make_shared<PlotArguments>();
    command->add_option("RUN", arguments->runs, "Folder of a run; several may be given")->required();
    command
        ->add_option("--measure", arguments->measures,
                     "Columns of series.csv, by measure, group or head; without it kinetic energy, circulation, slope, "
                     "energy lost, and the height of the first tracer")
        ->type_name("NAME,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--labels", arguments->labels, "What the runs are called in the legend; else their folders")
        ->type_name("A,B,...");
    command->add_option("--time", arguments->time, "Only from A to B, s; either may be missing")->type_name("A:B");
    command
        ->add_option("--out", arguments->out,
                     "The file: .png, .svg or .pdf; redrawn/plot.png in the first run's folder without it")
        ->type_name("FILE")
        ->check(refuse_no_place);
    add_canvas_flags(*command, arguments->canvas);
    command->add_flag("--force", arguments->force, "Replace what is there");
    command->add_flag("--quiet", arguments->quiet, "No warnings on stderr, nothing on stdout");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return plot_runs(*arguments); }; });
}

} // namespace tumble::cli
