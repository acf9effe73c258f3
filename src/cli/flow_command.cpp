#include "base/text.h"
#include "cli/canvas_flags.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "cli/time_range.h"
#include "run/flow_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <numeric>
#include <optional>

namespace tumble::cli {

namespace {

using Json = nlohmann::ordered_json;

struct FlowArguments {
    std::filesystem::path run;
    run::FlowOptions options;
    std::vector<double> axis{0, 0}, heights;
    std::optional<double> radius;
    std::filesystem::path out, picture;
    CanvasFlags canvas;
    std::string time;
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// NaN becomes null: JSON has no such number.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json layers_of(const run::FlowReport& report) {
    const observe::FlowGrid& grid = report.field.grid();
    Json layers = Json::array();
    for (int layer = 0; layer < grid.layers; ++layer) {
        const observe::FlowCell cell = report.field.layer(layer);
        const Eigen::Vector3d v = cell.mean_velocity();
        layers.push_back({{"from_m", grid.lo + layer * grid.layer_height()},
                          {"to_m", grid.lo + (layer + 1) * grid.layer_height()},
                          {"mass_kg", cell.mass / std::max(report.field.frames(), 1)},
                          {"v_radial_m_s", number(v.x())},
                          {"v_tangential_m_s", number(v.y())},
                          {"v_vertical_m_s", number(v.z())},
                          {"speed_m_s", number(cell.mean_speed())},
                          {"residence_s", number(report.residence.mean_s(layer))},
                          {"stays", report.residence.stays(layer)}});
    }
    return layers;
}

Json span_of(const std::vector<Eigen::Vector3d>& vectors, int axis) {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const Eigen::Vector3d& vector : vectors) {
        lo = std::min(lo, vector[axis]);
        hi = std::max(hi, vector[axis]);
    }
    return Json::array({number(lo), number(hi)});
}

Json path_of(const run::Path& path) {
    const observe::Cycle cycle = path.cycle();
    Json json{{"body", path.name},
              {"period_s", number(cycle.period)},
              {"peak_to_peak_m", number(cycle.peak_to_peak)},
              {"cycles", cycle.cycles}};
    const char* axes[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
        json[fmt::format("{}_m", axes[k])] = span_of(path.position, k);
        json[fmt::format("v{}_m_s", axes[k])] = span_of(path.velocity, k);
    }
    return json;
}

Json summary_of(const run::FlowReport& report) {
    const double kinetic = std::accumulate(report.kinetic.begin(), report.kinetic.end(), 0.0) /
                           static_cast<double>(std::max<std::size_t>(report.kinetic.size(), 1));
    Json paths = Json::array();
    for (const run::Path& path : report.paths)
        paths.push_back(path_of(path));
    return {{"frames", report.replayed.frames},
            {"first_s", report.replayed.first},
            {"last_s", report.replayed.last},
            {"kinetic_translation_J", kinetic},
            {"vortex_depth_m", observe::vortex_depth(report.field)},
            {"layers", layers_of(report)},
            {"bodies", paths},
            {"warnings", report.replayed.warnings}};
}

std::string entry(const Json& value, int digits = 3) {
    return value.is_null() ? "-" : fixed(value.get<double>(), digits);
}

void print(const Json& summary) {
    say(fmt::format("{} frames from {:.4g} to {:.4g} s: kinetic energy of translation {:.4g} J, vortex {:.1f} mm deep",
                    summary["frames"].get<int>(), summary["first_s"].get<double>(), summary["last_s"].get<double>(),
                    summary["kinetic_translation_J"].get<double>(), 1e3 * summary["vortex_depth_m"].get<double>()));
    std::vector<std::vector<std::string>> rows{
        {"height m", "mass kg", "radial m/s", "tangential m/s", "vertical m/s", "speed m/s", "residence s"}};
    for (const Json& layer : summary["layers"])
        rows.push_back({entry(layer["from_m"]) + " to " + entry(layer["to_m"]), entry(layer["mass_kg"]),
                        entry(layer["v_radial_m_s"]), entry(layer["v_tangential_m_s"]), entry(layer["v_vertical_m_s"]),
                        entry(layer["speed_m_s"]), entry(layer["residence_s"])});
    say(table(rows));
    for (const Json& body : summary["bodies"]) {
        say(fmt::format("{}: goes up and down by {} m (peak to peak), a cycle takes {} s ({} seen)",
                        body["body"].get<std::string>(), entry(body["peak_to_peak_m"], 4), entry(body["period_s"]),
                        body["cycles"].get<double>()));
        std::vector<std::vector<std::string>> spans{{"", "place m", "velocity m/s"}};
        for (const std::string axis : {"x", "y", "z"}) {
            const Json &place = body[axis + "_m"], &speed = body["v" + axis + "_m_s"];
            spans.push_back(
                {axis, entry(place[0]) + " to " + entry(place[1]), entry(speed[0]) + " to " + entry(speed[1])});
        }
        say(table(spans));
    }
}

std::vector<std::filesystem::path> files_of(const FlowArguments& arguments) {
    std::vector<std::filesystem::path> files;
    if (!arguments.out.empty())
        files = run::flow_files(arguments.out, arguments.options.bodies);
    if (!arguments.picture.empty())
        files.push_back(arguments.picture);
    return files;
}

int tell_flow(FlowArguments& arguments) {
    run::FlowOptions& options = arguments.options;
    options.grid.axis_x = arguments.axis[0];
    options.grid.axis_z = arguments.axis[1];
    options.fit_radius = !arguments.radius;
    options.grid.radius = arguments.radius.value_or(0);
    options.fit_heights = arguments.heights.empty();
    if (!options.fit_heights) {
        options.grid.lo = arguments.heights[0];
        options.grid.hi = arguments.heights[1];
        if (!(arguments.heights[0] < arguments.heights[1]))
            return refuse({{.file = "--heights",
                            .what = fmt::format("the lowest height, {} m, does not lie below the highest, {} m",
                                                arguments.heights[0], arguments.heights[1]),
                            .fix = "give the lower one first, as in --heights 0,0.16"}},
                          arguments.json, wrong);
    }
    if (const auto problem = read_time_range(arguments.time, options.when.from, options.when.to, arguments.run))
        return refuse({*problem}, arguments.json, wrong);
    const auto canvas = canvas_of(arguments.canvas, run::flow_canvas);
    if (!canvas)
        return refuse(canvas.problems(), arguments.json, wrong);
    if (!arguments.force)
        if (const auto problem = refuse_to_overwrite(files_of(arguments)))
            return refuse({*problem}, arguments.json, wrong);
    options.when.stop = &watch_for_stop();
    ProgressLine progress(arguments.quiet);
    const auto report =
        run::read_flow(arguments.run, options, [&](std::int64_t n, std::int64_t all) { progress.frames(n, all); });
    progress.end();
    if (!report)
        return refuse(report.problems(), arguments.json, wrong);
    if (report->replayed.stopped)
        return stop_code();
    if (!arguments.quiet)
        for (const std::string& warning : report->replayed.warnings)
            note("warning: " + warning);
    if (!arguments.out.empty())
        if (const auto written = run::write_flow(*report, arguments.out); !written)
            return refuse(written.problems(), arguments.json, failed);
    if (!arguments.picture.empty())
        if (const auto drawn = run::draw_flow(*report, arguments.picture, *canvas); !drawn)
            return refuse(drawn.problems(), arguments.json, failed);
    const Json summary = summary_of(*report);
    if (arguments.json)
        say_json(summary);
    else
        print(summary);
    return fine;
}

} // namespace

void add_flow_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "flow", "Example: tumble flow out/bowl-quick --time 1.2: --body sensor --out flow --picture flow.png\n\n"
                "The flow of a run about an upright axis, from its frames: mean velocities by distance and height, by\n"
                "layers, the vortex, how long bodies stay in a layer, and how single bodies go up and down.\n"
                "docs/measures.md has the formulas.");
    const auto arguments = std::make_shared<FlowArguments>();
    run::FlowOptions& options = arguments->options;
    options.grid.rings = 12;
    options.grid.layers = 10;
    command->add_option("RUN", arguments->run, "Folder of a run")->required();
    command->add_option("--time", arguments->time, "Only frames from A to B, s; either may be missing")
        ->type_name("A:B");
    command->add_option("--body", options.bodies, "Follow the first body of that name; may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    command->add_option("--axis", arguments->axis, "Where the axis stands, m; 0,0 without it")
        ->type_name("X,Z")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--radius", arguments->radius, "How far the rings reach, m; as far as bodies do without it")
        ->check(number_above_zero());
    command->add_option("--heights", arguments->heights, "Lowest and highest, m; as far as bodies reach without it")
        ->type_name("LO,HI")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--rings", options.grid.rings, "How many rings; 12 without it")
        ->check(whole_number_from(1, 1000));
    command->add_option("--layers", options.grid.layers, "How many layers; 10 without it")
        ->check(whole_number_from(1, 1000));
    command->add_option("--out", arguments->out, "Folder for tables (CSV)")->type_name("DIR")->check(refuse_no_place);
    command->add_option("--picture", arguments->picture, "Picture of the field (needs gnuplot)")
        ->type_name("FILE")
        ->check(refuse_no_place)
        ->check(ends_in({".png", ".svg", ".pdf"}));
    add_canvas_flags(*command, arguments->canvas);
    command->add_flag("--force", arguments->force, "Replace what is there");
    command->add_flag("--quiet", arguments->quiet, "No progress, no warnings on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return tell_flow(*arguments); }; });
}

} // namespace tumble::cli
