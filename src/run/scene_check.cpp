#include "run/scene_check.h"

#include "base/text.h"
#include "observe/frame_file.h"
#include "observe/measures.h"
#include "run/fill_plan.h"
#include "run/measure_names.h"
#include "run/scene_doubts.h"
#include "run/schedule.h"
#include "scene/extent.h"
#include "scene/laws.h"
#include "scene/read_file.h"
#include "scene/written.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace tumble::run {

namespace {

// Body-steps/s of one core in dense flow, bodies of many spheres and single spheres, as docs/performance.md has them
// for one machine: a guess at the cost, right within a factor of a few on others. Memory per body: state, candidate
// lists and contacts of a dense bed.
constexpr double clump_rate = 3e6;
constexpr double sphere_rate = 1.5e7;
constexpr double disc_rate = 3e7; // discs, those of clumps too
constexpr double hard_rate = 1e6; // bodies of Box2D at its usual iterations
// What a step takes however few the bodies, and a row or a frame: s, as run.json has them for single spheres.
constexpr double step_floor = 5e-7;
constexpr double output_floor = 1e-4;
constexpr double bytes_per_body = 2500;
constexpr double bytes_per_sphere = 60;
constexpr double bytes_of_program = 2e7;

void check_bodies(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies, SceneCheck& check) {
    const std::vector<std::int64_t> wanted = bodies_wanted(scene, bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        BodyCheck body{bodies[i], scene.materials[static_cast<std::size_t>(scene.bodies[i].material)].name, 0};
        for (std::size_t f = 0; f < scene.fills.size(); ++f) {
            const bool own = static_cast<std::size_t>(scene.fills[f].body) == i;
            body.wanted += own ? wanted[f] : 0;
            check.too_late += own && scene.fills[f].start >= scene.duration ? wanted[f] : 0;
        }
        check.wanted += body.wanted;
        check.mass += body.mass * static_cast<double>(body.wanted);
        check.parts += body.parts * static_cast<std::size_t>(body.wanted);
        check.bodies.push_back(std::move(body));
    }
}

void check_walls(const scene::Scene& scene, SceneCheck& check) {
    constexpr std::array shapes{"plane", "box", "cylinder", "disc", "trough", "mesh", "bowl", "bowl-disc", "specimen"};
    constexpr std::array outlines{"segment", "arc", "polyline", "box", "trough"};
    static_assert(shapes.size() == std::variant_size_v<scene::WallShape>);
    static_assert(outlines.size() == std::variant_size_v<scene::Outline>);
    for (const scene::Wall& wall : scene.walls) {
        const scene::Box extent = scene::extent_of(wall, scene.dimension);
        check.walls.push_back({wall.name,
                               scene.dimension == 2 ? outlines[wall.outline.index()] : shapes[wall.shape.index()],
                               scene.materials[static_cast<std::size_t>(wall.material)].name, extent.hi - extent.lo});
    }
}

void check_pairs(const scene::Scene& scene, SceneCheck& check) {
    std::set<std::pair<int, int>> meet;
    for (const scene::BodyTemplate& body : scene.bodies) {
        if (scene.bodies_can_meet())
            for (const scene::BodyTemplate& other : scene.bodies)
                meet.insert(std::minmax(body.material, other.material));
        for (const scene::Wall& wall : scene.walls)
            meet.insert(std::minmax(body.material, wall.material));
    }
    const bool hard = scene.solver == scene::Solver::box2d;
    const scene::ContactLaws& laws = scene.contact;
    const std::string normal = hard ? "box2d" : laws.normal == scene::NormalLaw::linear ? "linear" : "hertz";
    const std::string tangential = hard                                              ? "box2d"
                                   : laws.tangential == scene::TangentialLaw::none   ? "none"
                                   : laws.tangential == scene::TangentialLaw::linear ? "linear"
                                                                                     : "mindlin";
    const auto name = [&](int material) { return scene.materials[static_cast<std::size_t>(material)].name; };
    for (const auto& [a, b] : meet)
        check.pairs.push_back({name(a) + "-" + name(b), normal, tangential, scene.pair(a, b), scene.constants(a, b)});
}

void check_cost(const scene::Scene& scene, std::size_t columns, SceneCheck& check) {
    check.steps = std::llround(scene.duration / scene.step());
    check.rows = Schedule(scene.observe.every, scene.step()).count(check.steps);
    check.frames = Schedule(scene.render.every, scene.step()).count_with_last(check.steps);
    const auto bodies = static_cast<double>(check.wanted);
    check.memory_bytes =
        bytes_of_program + bodies * bytes_per_body + static_cast<double>(check.parts) * bytes_per_sphere;
    constexpr double bytes_per_cell = 20;
    check.disk_bytes =
        static_cast<double>(check.frames) *
            static_cast<double>(observe::frame_bytes(static_cast<std::size_t>(check.wanted), scene.walls.size())) +
        static_cast<double>(check.rows) * bytes_per_cell * static_cast<double>(columns + 1);
    check.body_steps = bodies * static_cast<double>(check.steps);
    const bool clumps = check.parts > static_cast<std::size_t>(check.wanted);
    check.assumed_rate = scene.solver == scene::Solver::box2d ? hard_rate
                         : scene.dimension == 2
                             ? disc_rate * bodies / std::max(bodies, static_cast<double>(check.parts))
                         : clumps ? clump_rate
                                  : sphere_rate;
    check.assumed_step = step_floor;
    const double seconds = check.body_steps / check.assumed_rate +
                           check.assumed_step * static_cast<double>(check.steps) +
                           output_floor * static_cast<double>(check.rows + check.frames);
    check.hours = seconds / 3600;
}

void look_for_oddities(const scene::Scene& scene, SceneCheck& check) {
    const auto say = [&](std::string sentence) { check.warnings.push_back(std::move(sentence)); };
    if (check.time_step.limit > 0 && check.time_step.step > 0.5 * check.time_step.limit)
        say(fmt::format(
            "the time step is {:.0f} % of the stable limit: stable, but the energy balance closes less well "
            "than below 50 %. Nothing needs to be done unless the run warns at its end of what the balance "
            "misses; then take a step of {} or less",
            100 * check.time_step.step / check.time_step.limit, format_si(0.5 * check.time_step.limit, "s", 2)));
    if (check.wanted == 0)
        say("no fill asks for bodies: nothing will move");
    if (scene.walls.empty())
        say("there is no wall: bodies fall out of the domain unless it is periodic");
    if (scene.observe.every < scene.step())
        say(fmt::format("observe.every_s is shorter than a step: every step gets one row, {} in all", check.rows));
    if (scene.render.every < scene.step())
        say(fmt::format(
            "render.every_s is shorter than a step: every step gets one frame, {} in all; the run writes {}",
            check.frames, scene::in_words(static_cast<std::size_t>(check.disk_bytes))));
    if (scene.observe.every > scene.duration)
        say("observe.every_s is longer than the run: only its first instant gets a row");
}

/// JSON has no infinity: null where a wall does not end, or any step will do.
nlohmann::ordered_json end(double size) {
    return std::isfinite(size) ? nlohmann::ordered_json(size) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json to_json(const scene::TimeStepReport& report) {
    return {{"step_s", report.step},
            {"limit_s", end(report.limit)},
            {"stable", report.stable()},
            {"rayleigh_s", report.rayleigh},
            {"rayleigh_of", report.rayleigh_of},
            {"hertz_s", report.hertz},
            {"hertz_of", report.hertz_of},
            {"hertz_speed_m_s", report.hertz_speed},
            {"body_period_s", report.body_period},
            {"body_of", report.body_of},
            {"linear_period_s", report.linear_period}};
}

nlohmann::ordered_json to_json(const PairCheck& pair) {
    return {{"pair", pair.name},
            {"normal", pair.normal},
            {"tangential", pair.tangential},
            {"effective_modulus_Pa", end(pair.taken.E_eff)},
            {"restitution", pair.given.restitution},
            {"friction", pair.given.friction},
            {"normal_stiffness_N_per_m", pair.given.normal_stiffness},
            {"tangential_stiffness_N_per_m", pair.given.tangential_stiffness},
            {"rolling", scene::words_of_rolling[static_cast<std::size_t>(pair.taken.rolling)]},
            {"rolling_friction", pair.given.rolling_friction},
            {"rolling_time_s", pair.given.rolling_time},
            {"adhesion", scene::words_of_adhesion[static_cast<std::size_t>(pair.taken.adhesion)]},
            {"cohesion_energy_J_m3", pair.given.cohesion_energy},
            {"work_of_adhesion_J_m2", pair.given.work_of_adhesion},
            {"cohesion_N", pair.given.cohesion}};
}

} // namespace

Result<SceneCheck> check_scene(const scene::Scene& scene, int threads, const Tally& tally) {
    Problems problems = check_measures(scene);
    for (Problem& problem : problems)
        problem = scene::placed(scene, std::move(problem));
    const Result<SimulationPtr> simulation = simulate(scene, threads, nullptr, tally);
    const Problems more = simulation.problems();
    problems.insert(problems.end(), more.begin(), more.end());
    if (!problems.empty())
        return problems;
    return check_built(scene, **simulation);
}

SceneCheck check_built(const scene::Scene& scene, const Simulation& simulation) {
    SceneCheck check;
    check.dimension = scene.dimension;
    const std::vector<SimulatedBody> bodies = simulation.bodies();
    check_bodies(scene, bodies, check);
    check.placed = static_cast<std::int64_t>(simulation.frame().bodies());
    check_walls(scene, check);
    check_pairs(scene, check);
    check.time_step = simulation.time_step();
    const auto measures = observe::choose_measures(scene.observe.measures);
    check_cost(scene, measures ? measures->size() : 0, check);
    check.warnings = scene_doubts(scene, bodies);
    look_for_oddities(scene, check);
    return check;
}

nlohmann::ordered_json to_json(const SceneCheck& check) {
    nlohmann::ordered_json bodies = nlohmann::ordered_json::array();
    for (const BodyCheck& body : check.bodies)
        bodies.push_back({{"name", body.name},
                          {"material", body.material},
                          {check.dimension == 2 ? "discs" : "spheres", body.parts},
                          {"volume_m3", body.volume},
                          {"mass_kg", body.mass},
                          {"inertia_kg_m2", {body.inertia.x(), body.inertia.y(), body.inertia.z()}},
                          {"bounding_radius_m", body.bounding_radius},
                          {"wanted", body.wanted}});
    nlohmann::ordered_json walls = nlohmann::ordered_json::array();
    for (const WallCheck& wall : check.walls)
        walls.push_back({{"name", wall.name},
                         {"shape", wall.shape},
                         {"material", wall.material},
                         {"size_m", {end(wall.size.x()), end(wall.size.y()), end(wall.size.z())}}});
    nlohmann::ordered_json pairs = nlohmann::ordered_json::array();
    for (const PairCheck& pair : check.pairs)
        pairs.push_back(to_json(pair));
    return {{"dimension", check.dimension},
            {"bodies", bodies},
            {"wanted", check.wanted},
            {"placed", check.placed},
            {"too_late", check.too_late},
            {"mass_kg", check.mass},
            {check.dimension == 2 ? "discs" : "spheres", check.parts},
            {"walls", walls},
            {"pairs", pairs},
            {"time_step", to_json(check.time_step)},
            {"steps", check.steps},
            {"rows", check.rows},
            {"frames", check.frames},
            {"memory_bytes", check.memory_bytes},
            {"disk_bytes", check.disk_bytes},
            {"body_steps", check.body_steps},
            {"assumed_body_steps_per_s", check.assumed_rate},
            {"assumed_step_s", check.assumed_step},
            {"hours_on_one_core", check.hours},
            {"warnings", check.warnings}};
}

} // namespace tumble::run
