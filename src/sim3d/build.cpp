#include "contact/jkr.h"
#include "scene/written.h"
#include "sim3d/body_shape.h"
#include "sim3d/fill.h"
#include "sim3d/state.h"
#include "sim3d/time_step.h"
#include "sim3d/world.h"
#include "solver/leashes.h"
#include "solver/prepare.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

// Lists as long as these parts of the bodies were found quickest on dense beds (bench/spheres, bench/trough).
constexpr double skin_per_bounding_radius = 0.2;
constexpr double sphere_skin_per_radius = 0.15;
constexpr double near_skin_per_skin = 0.25;
// Walls do not take part in the mean flow, so bodies may pass them long before they pass each other.
constexpr double wall_skin_per_skin = 3;
// Necks of adhesion must lie well within every skin.
constexpr double neck_per_radius = 0.04; // of the smallest radius

/// Smallest sphere around all spheres, by repeatedly stepping towards the farthest (Badoiu and Clarkson 2003); a little
/// too large is fine, too small never happens because the radius is measured at the end.
void find_bounding_sphere(const std::vector<scene::Sphere>& spheres, ShapeConstants& shape) {
    Vector3d centre = Vector3d::Zero();
    const auto farthest = [&] {
        return *std::max_element(spheres.begin(), spheres.end(), [&](const auto& a, const auto& b) {
            return (a.centre - centre).norm() + a.radius < (b.centre - centre).norm() + b.radius;
        });
    };
    for (int k = 1; k <= 2000 && spheres.size() > 1; ++k)
        centre += (farthest().centre - centre) / (k + 1.0);
    const scene::Sphere last = farthest();
    Eigen::Map<Vector3d>{shape.bounding_centre} = centre;
    shape.bounding_radius = (last.centre - centre).norm() + last.radius;
}

ShapeData prepare_shape(const BodyShape& shape, int material) {
    ShapeData data{shape, material, {}};
    for (const int k : contact_spheres(shape)) {
        const scene::Sphere& sphere = shape.spheres[static_cast<std::size_t>(k)];
        data.exposed.insert(data.exposed.end(),
                            {sphere.centre.x(), sphere.centre.y(), sphere.centre.z(), sphere.radius});
    }
    return data;
}

ShapeConstants constants_of(const ShapeData& data) {
    ShapeConstants constants{};
    constants.mass = data.shape.mass;
    Eigen::Map<Vector3d>{constants.inertia} = data.shape.inertia;
    constants.material = data.material;
    const Vector3d& inertia = data.shape.inertia;
    constants.single = data.shape.spheres.size() == 1 && inertia.minCoeff() == inertia.maxCoeff();
    constants.exposed = data.exposed.data();
    constants.exposed_count = static_cast<int>(data.exposed.size() / 4);
    for (const scene::Sphere& sphere : data.shape.spheres)
        constants.reach = std::max(constants.reach, sphere.centre.norm());
    find_bounding_sphere(data.shape.spheres, constants);
    return constants;
}

Problems make_shapes(World& world) {
    Problems problems;
    for (const scene::BodyTemplate& body : world.scene.bodies) {
        if (stop_wanted(world.stop))
            break;
        const auto shape = make_body_shape(body, world.scene.materials[static_cast<std::size_t>(body.material)]);
        if (!shape) {
            for (const Problem& problem : shape.problems())
                problems.push_back(scene::placed(world.scene, problem));
            continue;
        }
        world.plain_shapes.push_back(*shape);
        world.shapes.push_back(prepare_shape(*shape, body.material));
    }
    for (const ShapeData& data : world.shapes) {
        world.shape_constants.push_back(constants_of(data));
        world.has_clumps = world.has_clumps || !world.shape_constants.back().single;
    }
    return problems;
}

Problems make_walls(World& world) {
    Problems problems;
    const scene::Domain& domain = world.scene.domain;
    for (const scene::Wall& wall : world.scene.walls) {
        if (stop_wanted(world.stop))
            break;
        const auto surface = WallSurface::make(wall.shape, domain);
        if (!surface) {
            for (Problem problem : surface.problems()) {
                problem.key = "wall." + wall.name;
                problem.what = fmt::format("wall '{}': {}", wall.name, problem.what);
                problems.push_back(scene::placed(world.scene, std::move(problem)));
            }
            continue;
        }
        WallState state{wall, *surface, {}, {}, 0, 0, 0, turns_in_place(wall)};
        state.pose = pose_of(state, 0);
        state.half_pose = pose_of(state, -0.5 * world.dt);
        world.walls.push_back(std::move(state));
    }
    return problems;
}

/// Of the sphere of the body's volume.
void make_drag(World& world) {
    if (world.scene.air.there())
        for (const BodyShape& shape : world.plain_shapes)
            world.drag.push_back(
                contact::drag_of_sphere(world.scene.air, std::cbrt(6 * shape.volume / std::numbers::pi)));
}

/// How far necks of adhesion reach between the largest spheres, and between them and walls.
Problems make_necks(World& world) {
    double largest = 0;
    for (const ShapeConstants& shape : world.shape_constants)
        for (int s = 0; s < shape.exposed_count; ++s)
            largest = std::max(largest, shape.exposed[4 * s + 3]);
    for (const contact::PairConstants& pair : world.pairs)
        world.neck_reach.push_back(pair.adhesion == contact::AdhesionLaw::jkr ? contact::Jkr::reach(largest, pair)
                                                                              : 0.0);
    if (!world.neck_reach.empty())
        world.longest_neck = *std::max_element(world.neck_reach.begin(), world.neck_reach.end());
    if (world.longest_neck <= neck_per_radius * world.smallest_radius)
        return {};
    return {scene::problem_about(
        world.scene, "contact.adhesion",
        fmt::format("necks of adhesion would reach over {:.3g} m, more than {:.3g} of the smallest sphere's radius",
                    world.longest_neck, neck_per_radius),
        "a material so soft and sticky is beyond JKR; use a larger Young's modulus or a smaller work of adhesion")};
}

void choose_skins(World& world) {
    double largest = 0;
    double smallest_sphere = std::numeric_limits<double>::infinity();
    for (const ShapeConstants& shape : world.shape_constants) {
        largest = std::max(largest, shape.bounding_radius);
        for (int s = 0; s < shape.exposed_count; ++s)
            smallest_sphere = std::min(smallest_sphere, shape.exposed[4 * s + 3]);
    }
    world.smallest_radius = smallest_sphere;
    world.skin = world.scene.skin > 0 ? world.scene.skin : skin_per_bounding_radius * largest;
    world.near_skin = near_skin_per_skin * world.skin;
    world.wall_skin = wall_skin_per_skin * world.skin;
    world.sphere_skin = std::min(sphere_skin_per_radius * smallest_sphere, world.skin);
    for (const BodyShape& shape : world.plain_shapes)
        world.reach = std::max(world.reach, 2 * shape.bounding_radius + solver::longest_leash * world.skin);
}

Problems check_periods(const World& world) {
    Problems problems;
    const scene::Domain& domain = world.scene.domain;
    double reach = 0;
    for (const ShapeConstants& shape : world.shape_constants)
        reach = std::max(reach, 2 * shape.bounding_radius + Vector3d(shape.bounding_centre).norm() +
                                    solver::longest_leash * world.skin);
    for (int k = 0; k < 3; ++k)
        if (domain.periodic[static_cast<std::size_t>(k)] && domain.box.hi[k] - domain.box.lo[k] < reach)
            problems.push_back(scene::problem_about(
                world.scene, "domain",
                fmt::format("the domain is {:.4g} m long in its periodic direction {}, but a body must never meet its "
                            "own image: at least {:.4g} m are needed",
                            domain.box.hi[k] - domain.box.lo[k], "xyz"[k], reach),
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
    world->images = solver::images_of(scene.domain, 3);
    Problems problems = make_shapes(*world);
    append(problems, make_walls(*world));
    append(problems, solver::faults_of_laws(scene, 3));
    if (stop_wanted(stop))
        return stopped_before_it_began();
    if (!problems.empty())
        return problems;
    choose_skins(*world);
    make_drag(*world);
    append(problems, make_necks(*world));
    append(problems, check_periods(*world));
    append(problems, solver::faults_of_step(scene, time_step_report(scene, world->plain_shapes), "materials"));
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

} // namespace tumble::sim3d
