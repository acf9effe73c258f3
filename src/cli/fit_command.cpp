#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "fit/report.h"
#include "fit/spheres.h"
#include "observe/whole_file.h"
#include "scene/read_clump.h"
#include "scene/read_stl.h"

#include <fmt/format.h>
#include <memory>
#include <thread>

namespace tumble::cli {

namespace {

constexpr double large_solid = 1; // m3; no medium that is tumbled is as large

struct FitArguments {
    std::filesystem::path mesh;
    std::vector<double> cone_mm; // diameter, height
    double scale = 1;
    int spheres = 0;
    double smallest_mm = 0.5;
    double volume_mm3 = 0;
    std::filesystem::path compare;
    std::filesystem::path out;
    bool force = false;
    bool quiet = false;
    bool json = false;
};

/// A solid, and spheres for it.
struct Fitted {
    fit::Solid solid;
    std::vector<scene::Sphere> spheres;
};

Result<Fitted> fitted(const FitArguments& arguments) {
    const fit::Wanted wanted{arguments.spheres, arguments.smallest_mm * 1e-3};
    Fitted result;
    Problems problems;
    ProgressLine line(arguments.quiet);
    const Tally tally = [&](auto... told) { line.prepares(told...); };
    const auto take = [&](Result<std::vector<scene::Sphere>> spheres) {
        problems = spheres.problems();
        if (spheres)
            result.spheres = std::move(*spheres);
    };
    if (!arguments.cone_mm.empty()) {
        const fit::Cone cone{arguments.cone_mm[0] * 1e-3, arguments.cone_mm[1] * 1e-3};
        result.solid = fit::solid_of(cone);
        if (arguments.compare.empty())
            take(fit::spheres_in(cone, wanted, tally));
    } else {
        auto faces = scene::read_stl(arguments.mesh);
        if (!faces)
            return faces.problems();
        for (fit::Triangle& face : *faces)
            for (Eigen::Vector3d& corner : face)
                corner *= arguments.scale;
        auto solid = fit::solid_of(std::move(*faces));
        if (!solid) {
            problems = solid.problems();
            for (Problem& problem : problems)
                problem.file = arguments.mesh.string();
            return problems;
        }
        result.solid = std::move(*solid);
        if (const double volume = result.solid.volume; volume > large_solid && !arguments.quiet)
            note(fmt::format("warning: {} holds {:.3g} litres; an STL in millimetres wants --scale 0.001",
                             arguments.mesh.string(), 1e3 * volume));
        if (arguments.compare.empty())
            take(fit::spheres_in(result.solid, wanted,
                                 std::max(1, static_cast<int>(std::thread::hardware_concurrency())), &watch_for_stop(),
                                 tally));
    }
    line.end();
    if (!arguments.compare.empty())
        take(scene::read_clump(arguments.compare));
    if (!problems.empty())
        return problems;
    return result;
}

std::vector<std::string> how_it_was_made(const FitArguments& arguments, double factor) {
    const std::string what = arguments.cone_mm.empty()
                                 ? arguments.mesh.filename().string() +
                                       (arguments.scale == 1 ? "" : fmt::format(" --scale {}", arguments.scale))
                                 : fmt::format("--cone {},{}", arguments.cone_mm[0], arguments.cone_mm[1]);
    std::vector<std::string> lines;
    lines.push_back(fmt::format("Made by: tumble fit {} --spheres {} --smallest {}{}", what, arguments.spheres,
                                arguments.smallest_mm,
                                arguments.volume_mm3 > 0 ? fmt::format(" --volume {}", arguments.volume_mm3) : ""));
    if (arguments.volume_mm3 > 0)
        lines.push_back(fmt::format("(all lengths times {:.6f} at the end, for that volume)", factor));
    return lines;
}

nlohmann::ordered_json json_of(const fit::Report& report, std::size_t spheres) {
    const auto list = [](const Eigen::Vector3d& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
    return {{"spheres", spheres},
            {"volume_m3", report.union_volume},
            {"solid_volume_m3", report.solid_volume},
            {"centre_m", list(report.union_centre)},
            {"solid_centre_m", list(report.solid_centre)},
            {"inertia_m5", list(report.union_inertia)},
            {"solid_inertia_m5", list(report.solid_inertia)},
            {"surface_gap_mean_m", report.gap_mean},
            {"surface_gap_max_m", report.gap_max},
            {"stands_out_m", report.stands_out},
            {"smallest_radius_m", report.smallest},
            {"largest_radius_m", report.largest},
            {"equivalent_radius_m", fit::equivalent_radius(report.union_volume)}};
}

int fit_it(const FitArguments& arguments) {
    if (arguments.cone_mm.empty() == arguments.mesh.empty())
        return refuse(
            {{.what = "nothing to fit to, or two things", .fix = "give a mesh.stl or --cone DIAMETER,HEIGHT"}},
            arguments.json, wrong);
    if (arguments.spheres < 1 && arguments.compare.empty())
        return refuse({{.what = "it is not said how many spheres", .fix = "give --spheres N, or --compare CLUMP.csv"}},
                      arguments.json, wrong);
    if (!arguments.out.empty() && !arguments.force)
        if (const auto problem = refuse_to_overwrite({arguments.out}))
            return refuse({*problem}, arguments.json, wrong);
    auto result = fitted(arguments);
    if (stop_wanted(&watch_for_stop()))
        return stop_code();
    if (!result)
        return refuse(result.problems(), arguments.json, wrong);
    const double factor =
        arguments.volume_mm3 > 0 ? fit::scale_to_volume(result->spheres, arguments.volume_mm3 * 1e-9) : 1;
    const fit::Report report = fit::compare(result->solid, result->spheres);
    if (!arguments.out.empty()) {
        const std::string text = fit::clump_file(result->spheres, report, how_it_was_made(arguments, factor));
        if (const auto written = observe::write_whole(arguments.out, text); !written)
            return refuse(written.problems(), arguments.json, failed);
    }
    if (arguments.json)
        say_json(json_of(report, result->spheres.size()));
    else
        for (const std::string& line : fit::sentences(report, result->spheres.size()))
            say(line);
    if (arguments.compare.empty() && arguments.volume_mm3 == 0 && !arguments.quiet)
        for (const std::string& line : fit::advice(report))
            note("advice: " + line);
    return fine;
}

} // namespace

void add_fit_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "fit",
        "Example: tumble fit --cone 10,12 --spheres 36 --out cone.csv\n\n"
        "Fits spheres to a cone or to the body inside a closed STL mesh, writes them as a clump for a scene, and\n"
        "says how far volume, inertia and surface are off. The same call gives the same spheres.");
    const auto arguments = std::make_shared<FitArguments>();
    command->add_option("MESH", arguments->mesh, "Closed mesh, ASCII or binary STL");
    command->add_option("--cone", arguments->cone_mm, "An upright cone instead: diameter and height, mm")
        ->type_name("D,H")
        ->delimiter(',')
        ->expected(2)
        ->check(number_above_zero());
    command->add_option("--scale", arguments->scale, "Metres per unit of the mesh: 0.001 for millimetres")
        ->check(number_above_zero());
    command->add_option("--spheres", arguments->spheres, "How many")
        ->type_name("N")
        ->check(whole_number_from(1, static_cast<long long>(scene::most_spheres)));
    command->add_option("--smallest", arguments->smallest_mm, "Least radius, mm; 0.5 without it")
        ->type_name("R")
        ->check(number_above_zero());
    command->add_option("--volume", arguments->volume_mm3, "Scale at the end so that the union has this volume, mm3")
        ->type_name("V")
        ->check(number_above_zero());
    command->add_option("--compare", arguments->compare, "Fit nothing; say how far this clump is off")
        ->type_name("CLUMP.csv");
    command->add_option("--out", arguments->out, "Clump file to write")->type_name("FILE")->check(refuse_no_place);
    command->add_flag("--force", arguments->force, "Replace what is there");
    command->add_flag("--quiet", arguments->quiet, "No progress, no advice on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return fit_it(*arguments); }; });
}

} // namespace tumble::cli
