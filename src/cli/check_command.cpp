#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_arguments.h"
#include "run/scene_check.h"
#include "scene/read_file.h"

#include <fmt/format.h>
#include <memory>
#include <thread>

namespace tumble::cli {

namespace {

struct CheckArguments {
    SceneArguments scene;
    bool json = false;
};

std::string bodies_text(const run::SceneCheck& check) {
    std::vector<std::vector<std::string>> rows{{"body", "wanted", "spheres", "mass", "volume", "material"}};
    for (const run::BodyCheck& body : check.bodies)
        rows.push_back({body.name, std::to_string(body.wanted), std::to_string(body.spheres),
                        format_si(body.mass * 1e3, "g", 4), fmt::format("{:.4g} mm3", body.volume * 1e9),
                        body.material});
    return table(rows);
}

std::string step_text(const sim3d::TimeStepReport& report) {
    const auto share = [&](double scale) {
        return scale > 0 ? fmt::format("{:.1f} %", 100 * report.step / scale) : "-";
    };
    std::vector<std::vector<std::string>> rows{
        {"time step", format_si(report.step, "s", 4), "", ""},
        {"stable limit", format_si(report.limit, "s", 4), share(report.limit), ""},
        {"Rayleigh time", format_si(report.rayleigh, "s", 4), share(report.rayleigh), report.rayleigh_of},
        {"Hertz contact", format_si(report.hertz, "s", 4), share(report.hertz),
         fmt::format("{} at {:.3g} m/s", report.hertz_of, report.hertz_speed)},
        {"body on contact", format_si(report.body_period, "s", 4), share(report.body_period), report.body_of}};
    if (report.linear_period > 0)
        rows.push_back({"linear contact", format_si(report.linear_period, "s", 4), share(report.linear_period), ""});
    return table(rows);
}

std::string cost_text(const run::SceneCheck& check, const scene::Render& settings) {
    const auto size = [](double bytes) { return scene::in_words(static_cast<std::size_t>(bytes)); };
    return table(
        {{"steps", fmt::format("{}", check.steps)},
         {"written", fmt::format("{} rows, {} frames, about {} without pictures", check.rows, check.frames,
                                 size(check.disk_bytes))},
         {"drawn", fmt::format("with --frames or --video {} of {} x {}, beside the steps: not in the time below",
                               counted(check.frames, "picture", "pictures"), settings.width, settings.height)},
         {"memory", fmt::format("about {}", size(check.memory_bytes))},
         {"time", fmt::format("about {} on one core, taking {:.1g} body-steps/s", duration(3600 * check.hours),
                              check.assumed_rate)}});
}

int check_it(const CheckArguments& arguments) {
    const Result<scene::Scene> scene = arguments.scene.load();
    if (!scene)
        return refuse(scene.problems(), arguments.json, wrong);
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const Result<run::SceneCheck> check = run::check_scene(*scene, threads);
    if (!check)
        return refuse(check.problems(), arguments.json, wrong);
    if (arguments.json) {
        nlohmann::ordered_json json{{"scene", scene->file.string()}, {"title", scene->title}};
        json.update(run::to_json(*check));
        say_json(json);
        return fine;
    }
    say(scene->title + "\n");
    say(bodies_text(*check) + fmt::format("\nall: {} of {:.4g} kg, {}\n", counted(check->wanted, "body", "bodies"),
                                          check->mass,
                                          counted(static_cast<long long>(check->walls.size()), "wall", "walls")));
    say(step_text(check->time_step) + "\n");
    say(cost_text(*check, scene->render));
    for (const std::string& warning : check->warnings)
        note("warning: " + warning);
    return fine;
}

} // namespace

void add_check_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "check", "Example: tumble check scenes/drop.toml\n\n"
                 "Says what a scene means: masses, counts, time step against its limits, memory, disk and\n"
                 "time. Takes no step and writes nothing. Exit code 2 where `run` would refuse the scene.");
    const auto arguments = std::make_shared<CheckArguments>();
    arguments->scene.add_to(*command);
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return check_it(*arguments); }; });
}

} // namespace tumble::cli
