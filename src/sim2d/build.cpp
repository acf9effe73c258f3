#include "discs/body_shape.h"
#include "scene/written.h"
#include "sim2d/fill.h"
#include "sim2d/state.h"
#include "sim2d/time_step.h"
#include "sim2d/world.h"
#include "solver/leashes.h"
#include "solver/prepare.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace tumble::sim2d {

namespace {

using Eigen::Vector2d;

// Lists as long as these parts of the bodies were found quickest on dense beds (bench/discs).
constexpr double skin_per_radius = 0.25;
constexpr double near_skin_per_skin = 0.3;
// Walls do not take part in the mean flow, so discs may pass them long before they pass each other.
constexpr double wall_skin_per_skin = 4;

ShapeConstants constants_of(const ShapeData& data) {
    ShapeConstants constants{};
    constants.mass = data.shape.mass;
    constants.inertia = data.shape.inertia;
    constants.reach = data.shape.bounding_radius;
    constants.material = data.material;
    constants.exposed = data.exposed.data();
    constants.exposed_count = static_cast<int>(data.exposed.size() / 3);
    // A lone disc that another covers may stand beside the centre of mass; then it is carried like a clump's.
    constants.single = data.exposed.size() == 3 && Vector2d(data.exposed[0], data.exposed[1]).norm() == 0;
    constants.smallest_radius = data.exposed[2];
    for (std::size_t k = 2; k < data.exposed.size(); k += 3)
        constants.smallest_radius = std::min(constants.smallest_radius, data.exposed[k]);
    return constants;
}

Problems make_shapes(World& world) {
    Result<std::vector<ShapeData>> shapes = discs::shapes_for(world.scene);
    if (!shapes)
        return shapes.problems();
    world.shapes = std::move(*shapes);
    for (const ShapeData& data : world.shapes) {
        world.plain_shapes.push_back(data.shape);
        world.shape_constants.push_back(constants_of(data));
    }
    return {};
}

void make_walls(World& world) {
    for (const scene::Wall& wall : world.scene.walls)
        world.walls.push_back({wall, WallLine(wall.outline, world.scene.domain),
                               WallFrame(scene::pose_at(wall.motion, 0)),
                               WallFrame(scene::pose_at(wall.motion, -0.5 * world.dt)), 0});
}

/// Of the disc of the body's area.
void make_drag(World& world) {
    if (world.scene.air.there())
        for (const BodyShape& shape : world.plain_shapes)
            world.drag.push_back(contact::drag_of_disc(world.scene.air, 2 * std::sqrt(shape.area / std::numbers::pi),
                                                       world.scene.depth));
}

void choose_skins(World& world) {
    world.smallest_radius = std::numeric_limits<double>::infinity();
    for (const ShapeData& data : world.shapes)
        for (std::size_t k = 2; k < data.exposed.size(); k += 3) {
            world.largest_radius = std::max(world.largest_radius, data.exposed[k]);
            world.smallest_radius = std::min(world.smallest_radius, data.exposed[k]);
        }
    world.skin = world.scene.skin > 0 ? world.scene.skin : skin_per_radius * world.largest_radius;
    world.near_skin = near_skin_per_skin * world.skin;
    world.wall_skin = wall_skin_per_skin * world.skin;
    world.reach = 2 * world.largest_radius + solver::longest_leash * world.skin;
}

/// Two discs must never meet through two images, nor a body its own: kept_memory.h counts on it.
Problems check_periods(const World& world) {
    Problems problems;
    const scene::Domain& domain = world.scene.domain;
    double needed = 2 * world.reach;
    for (const BodyShape& shape : world.plain_shapes)
        needed = std::max(needed, 2 * shape.bounding_radius + world.reach);
    for (int k = 0; k < 2; ++k)
        if (domain.periodic[static_cast<std::size_t>(k)] && domain.box.hi[k] - domain.box.lo[k] < needed)
            problems.push_back(scene::problem_about(
                world.scene, "domain",
                fmt::format("the domain is {:.4g} m long in its periodic direction {}, but discs must never meet "
                            "through two of its ends: at least {:.4g} m are needed",
                            domain.box.hi[k] - domain.box.lo[k], "xy"[k], needed),
                "make the domain longer or the bodies smaller"));
    return problems;
}

/// All of the world but its bodies.
Result<WorldPtr> prepare_world(const scene::Scene& scene, int threads, StopFlag stop) {
    WorldPtr world(new World(std::max(threads, 1)));
    world->scene = scene;
    world->dt = scene.time_step;
    world->stop = stop;
    world->kernels = &choose_kernels();
    world->materials = static_cast<int>(scene.materials.size());
    world->pairs = solver::pairs_of(scene);
    world->remembers_more = solver::remember_more(world->pairs);
    world->images = solver::images_of(scene.domain, 2);
    Problems problems = make_shapes(*world);
    append(problems, solver::faults_of_laws(scene, 2));
    if (stop_wanted(stop))
        return stopped_before_it_began();
    if (!problems.empty())
        return problems;
    make_walls(*world);
    choose_skins(*world);
    make_drag(*world);
    append(problems, check_periods(*world));
    append(problems, solver::faults_of_step(scene, time_step_report(scene, world->plain_shapes), "contacts"));
    append(problems, prepare_fills(*world));
    if (!problems.empty())
        return problems;
    return world;
}

} // namespace

Result<WorldPtr> build_world(const scene::Scene& scene, int threads, StopFlag stop, const Tally& tally) {
    Result<WorldPtr> world = prepare_world(scene, threads, stop);
    if (world)
        if (auto problem = insert_due_fills(**world, tally))
            return *problem;
    if (stop_wanted(stop))
        return stopped_before_it_began();
    return world;
}

Result<WorldPtr> restore_world(const scene::Scene& scene, int threads, std::string_view state, StopFlag stop) {
    Result<WorldPtr> world = prepare_world(scene, threads, stop);
    if (world)
        if (auto problem = restore(**world, state))
            return *problem;
    return world;
}

} // namespace tumble::sim2d
