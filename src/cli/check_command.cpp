#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "run/scene_check.h"
#include "scene/read_file.h"

#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <thread>

namespace tumble::cli {

namespace {

struct CheckArguments {
    SceneArguments scene;
    bool quiet = false;
    bool json = false;
};

std::string bodies_text(const run::SceneCheck& check) {
    std::vector<std::vector<std::string>> rows{
        {"body", "wanted", check.dimension == 2 ? "discs" : "spheres", "mass", "volume", "material"}};
    for (const run::BodyCheck& body : check.bodies)
        rows.push_back({body.name, std::to_string(body.wanted), std::to_string(body.parts),
                        format_si(body.mass * 1e3, "g", 4), fmt::format("{:.4g} mm3", body.volume * 1e9),
                        body.material});
    return table(rows);
}

std::string walls_text(const run::SceneCheck& check) {
    const auto side = [](double size) { return std::isfinite(size) ? format_si(size, "m", 3) : "endless"; };
    std::vector<std::vector<std::string>> rows{{"wall", "shape", "material", "x", "y"}};
    if (check.dimension == 3)
        rows[0].emplace_back("z");
    for (const run::WallCheck& wall : check.walls) {
        rows.push_back({wall.name, wall.shape, wall.material});
        for (int k = 0; k < check.dimension; ++k)
            rows.back().push_back(side(wall.size[k]));
    }
    return table(rows);
}

std::string contact_words(const run::PairCheck& pair) {
    if (pair.normal == "box2d")
        return "impulses of Box2D";
    std::string words = pair.normal + ", ";
    if (pair.normal == "hertz")
        words += "E* " + format_si(pair.taken.E_eff, "Pa", 3);
    else
        words += pair.given.contact_time > 0 ? "contacts of " + format_si(pair.given.contact_time, "s", 3)
                                             : format_si(pair.given.normal_stiffness, "N/m", 3);
    words += "; " + (pair.tangential == "none" ? "nothing tangential" : pair.tangential);
    if (pair.tangential == "linear")
        words += pair.given.stiffness_ratio > 0 ? fmt::format(", {:.3g} of that", pair.given.stiffness_ratio)
                                                : ", " + format_si(pair.given.tangential_stiffness, "N/m", 3);
    return words;
}

std::string restitution_words(const run::PairCheck& pair) {
    const contact::PairProperties& given = pair.given;
    if (given.damping_time > 0)
        return "dashpot of " + format_si(given.damping_time, "s", 3);
    std::string words = fmt::format("{:.3g}", given.restitution);
    if (given.restitution_exponent > 0)
        words += fmt::format(" at {:.3g} m/s, power -{:.3g}", given.restitution_speed, given.restitution_exponent);
    if (pair.taken.sticking_speed > 0)
        words += ", sticks below " + format_si(pair.taken.sticking_speed, "m/s", 3);
    return words;
}

std::string friction_words(const run::PairCheck& pair) {
    if (pair.taken.sliding_speed > 0)
        return fmt::format("{:.3g}, in fast sliding {:.3g}", pair.given.friction, pair.given.sliding_friction);
    return fmt::format("{:.3g}", pair.given.friction);
}

std::string rolling_words(const run::PairCheck& pair) {
    const std::string viscous =
        pair.taken.rolling_time > 0 ? "viscous " + format_si(pair.taken.rolling_time, "s", 3) : "";
    const std::string also = viscous.empty() ? "" : ", " + viscous;
    switch (pair.taken.rolling) {
    case contact::RollingLaw::none:
        return viscous.empty() ? "none" : viscous;
    case contact::RollingLaw::cdt:
        return fmt::format("cdt {:.3g}{}", pair.given.rolling_friction, also);
    case contact::RollingLaw::epsd:
        return fmt::format("epsd {:.3g}, damping {:.3g}{}", pair.given.rolling_friction, pair.given.rolling_damping,
                           also);
    }
    return "";
}

std::string cohesion_words(const run::PairCheck& pair) {
    const contact::PairProperties& given = pair.given;
    switch (pair.taken.adhesion) {
    case contact::AdhesionLaw::none:
        return given.cohesion > 0 ? format_si(given.cohesion, "N", 3) : "none";
    case contact::AdhesionLaw::sjkr:
        return fmt::format("sjkr, {:.3g} J/m3", given.cohesion_energy);
    case contact::AdhesionLaw::jkr:
        return fmt::format("jkr, {:.3g} J/m2", given.work_of_adhesion);
    case contact::AdhesionLaw::dmt:
        return fmt::format("dmt, {:.3g} J/m2", given.work_of_adhesion);
    }
    return "";
}

std::string pairs_text(const run::SceneCheck& check) {
    std::vector<std::vector<std::string>> rows{{"pair", "contact", "restitution", "friction", "rolling", "cohesion"}};
    for (const run::PairCheck& pair : check.pairs)
        rows.push_back({pair.name, contact_words(pair), restitution_words(pair), friction_words(pair),
                        rolling_words(pair), cohesion_words(pair)});
    return table(rows);
}

/// What is doubtful is part of the answer, so it stands with it and not on stderr.
std::string warnings_text(const run::SceneCheck& check) {
    std::string text;
    for (const std::string& warning : check.warnings)
        text += "\nwarning: " + warning;
    return text;
}

std::string step_text(const scene::TimeStepReport& report) {
    const auto share = [&](double scale) {
        return scale > 0 ? fmt::format("{:.1f} %", 100 * report.step / scale) : "-";
    };
    std::vector<std::vector<std::string>> rows{{"time step", format_si(report.step, "s", 4), "", ""}};
    if (report.body_period > 0) { // something can touch
        rows.push_back({"stable limit", format_si(report.limit, "s", 4), share(report.limit), ""});
        rows.push_back(
            {"body on contact", format_si(report.body_period, "s", 4), share(report.body_period), report.body_of});
    }
    if (report.rayleigh > 0)
        rows.push_back(
            {"Rayleigh time", format_si(report.rayleigh, "s", 4), share(report.rayleigh), report.rayleigh_of});
    if (report.hertz > 0)
        rows.push_back({"Hertz contact", format_si(report.hertz, "s", 4), share(report.hertz),
                        fmt::format("{} at {:.3g} m/s", report.hertz_of, report.hertz_speed)});
    if (report.linear_period > 0)
        rows.push_back({"linear contact", format_si(report.linear_period, "s", 4), share(report.linear_period), ""});
    return table(rows);
}

std::string cost_text(const run::SceneCheck& check, const scene::Render& settings) {
    const double seconds = 3600 * check.hours;
    const auto size = [](double bytes) { return scene::in_words(static_cast<std::size_t>(bytes)); };
    return table(
        {{"steps", fmt::format("{}", check.steps)},
         {"written", fmt::format("{} rows, {} frames, about {} without pictures", check.rows, check.frames,
                                 size(check.disk_bytes))},
         {"drawn", fmt::format("with --frames or --video {} of {} x {}, beside the steps: not in the time below",
                               counted(check.frames, "picture", "pictures"), settings.width, settings.height)},
         {"memory", fmt::format("about {}", size(check.memory_bytes))},
         {"time", fmt::format("{} on one core, taking {:.1g} body-steps/s and {} a step at least",
                              seconds < 1 ? "less than 1 s" : "about " + duration(seconds), check.assumed_rate,
                              format_si(check.assumed_step, "s", 3))}});
}

int check_it(const CheckArguments& arguments) {
    const Result<scene::Scene> scene = arguments.scene.load();
    if (!scene)
        return refuse(scene.problems(), arguments.json, wrong);
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    ProgressLine line(arguments.quiet);
    const Result<run::SceneCheck> check =
        run::check_scene(*scene, threads, [&](auto... told) { line.prepares(told...); });
    line.end();
    if (!check)
        return refuse(check.problems(), arguments.json, wrong);
    if (arguments.json) {
        nlohmann::ordered_json json{{"scene", scene->file.string()}, {"title", scene->title}};
        json.update(run::to_json(*check));
        say_json(json);
        return fine;
    }
    say(scene->title + "\n");
    say(bodies_text(*check) + fmt::format("\nall: {} of {:.4g} kg, {} of them at the start\n",
                                          counted(check->wanted, "body", "bodies"), check->mass, check->placed));
    if (!check->walls.empty())
        say(walls_text(*check) + "\n");
    if (!check->pairs.empty())
        say(pairs_text(*check) + "\n");
    say(step_text(check->time_step) + "\n");
    say(cost_text(*check, scene->render) + warnings_text(*check));
    return fine;
}

} // namespace

void add_check_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "check", "Example: tumble check scenes/drop.toml\n\n"
                 "Says what a scene means: masses, counts, sizes, laws, time step against its limits, memory,\n"
                 "disk and time, and warns of what is hardly meant. Takes no step and writes nothing. Exit\n"
                 "code 2 where `run` would refuse the scene.");
    const auto arguments = std::make_shared<CheckArguments>();
    arguments->scene.add_to(*command);
    command->add_flag("--quiet", arguments->quiet, "No progress on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return check_it(*arguments); }; });
}

} // namespace tumble::cli
