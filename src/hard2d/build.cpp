#include "hard2d/step.h"
#include "scene/written.h"
#include "solver/advance.h"

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_fixture.h>
#include <cmath>
#include <fmt/format.h>

namespace tumble::hard2d {

namespace {

using Eigen::Vector2d;

void open_box(World& world) {
    const scene::Scene& scene = world.scene;
    world.box = std::make_unique<b2World>(world.units.rate(Vector2d(scene.gravity.head<2>())));
    world.box->SetAllowSleeping(false); // a heap that creeps must be seen to creep
    world.contacts.answer_with(scene, scene.box2d.rebound_above * world.units.length);
    world.box->SetContactListener(&world.contacts);
    for (const scene::Wall& wall : scene.walls)
        world.walls.emplace_back(wall, scene.domain, world.units, *world.box);
}

Problems check_sides(const scene::Scene& scene) {
    for (int k = 0; k < 2; ++k)
        if (scene.domain.periodic[static_cast<std::size_t>(k)])
            return {scene::problem_about(scene, "domain.periodic", "solver = \"box2d\" knows no periodic sides",
                                         "close the sides with walls, or write solver = \"soft\"")};
    return {};
}

/// A wall that Box2D would not let keep its speed would lag behind its poses.
Problems check_walls(const World& world) {
    const scene::Scene& scene = world.scene;
    const Vector2d middle = (scene.domain.box.lo + scene.domain.box.hi).head<2>() / 2;
    const double reach = (scene.domain.box.hi - scene.domain.box.lo).head<2>().norm() / 2;
    for (const scene::Wall& wall : scene.walls) {
        const double speed = scene::speed_bound(wall.motion, {middle.x(), middle.y(), 0}, reach);
        const double most = b2_maxTranslation / (world.units.length * world.dt);
        if (speed > most)
            return {scene::problem_about(
                scene, "wall." + wall.name,
                fmt::format("wall '{}' moves at up to {:.4g} m/s, and Box2D moves nothing further than "
                            "twice the smallest radius in a step: {:.4g} m/s",
                            wall.name, speed, most),
                "shorten box2d.time_step_s")};
    }
    return {};
}

discs::Site site_of(const World& world, const Tally& tally) {
    discs::Site site{world.scene, world.shapes, {}, {}, world.step, world.dt, world.stop, tally};
    for (const Wall& wall : world.walls)
        site.walls.push_back({&wall.line(), discs::WallFrame(scene::pose_at(wall.motion(), world.time()))});
    for (const BodyState& body : bodies_of(world))
        site.bodies.push_back({body.shape, body.position, body.angle});
    return site;
}

/// A body of circles with the mass and inertia of their union.
b2Body* put(World& world, const BodyState& state) {
    const Units& units = world.units;
    const discs::ShapeData& data = world.shapes[static_cast<std::size_t>(state.shape)];
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = units.place(state.position);
    definition.angle = static_cast<float>(state.angle);
    definition.linearVelocity = units.rate(state.velocity);
    definition.angularVelocity = static_cast<float>(state.angular_velocity);
    definition.linearDamping = definition.angularDamping = static_cast<float>(world.scene.contact.global_damping);
    b2Body* body = world.box->CreateBody(&definition);
    for (std::size_t k = 0; k < data.exposed.size(); k += 3) {
        b2CircleShape circle;
        circle.m_p = units.rate(Vector2d(data.exposed[k], data.exposed[k + 1]));
        circle.m_radius = static_cast<float>(units.length * data.exposed[k + 2]);
        b2FixtureDef fixture;
        fixture.shape = &circle;
        fixture.userData.pointer =
            reinterpret_cast<std::uintptr_t>(&world.parts[static_cast<std::size_t>(state.shape)]);
        body->CreateFixture(&fixture);
    }
    b2MassData mass;
    mass.mass = static_cast<float>(units.mass * data.shape.mass);
    mass.center.SetZero();
    mass.I = static_cast<float>(units.mass * units.length * units.length * data.shape.inertia);
    body->SetMassData(&mass);
    return body;
}

} // namespace

void WorldDeleter::operator()(World* world) const {
    delete world;
}

std::optional<Problem> insert_due_fills(World& world, const Tally& tally) {
    const Result<std::vector<BodyState>> placed = discs::place_due(world.fills, site_of(world, tally));
    if (!placed)
        return placed.problems().front();
    world.next_fill_step = solver::next_due(world.fills);
    return insert(world, *placed);
}

Result<WorldPtr> build_world(const scene::Scene& scene, StopFlag stop, const Tally& tally) {
    if (Problems problems = check_sides(scene); !problems.empty())
        return problems;
    WorldPtr world(new World);
    world->scene = scene;
    world->dt = scene.box2d.time_step;
    world->stop = stop;
    Result<std::vector<discs::ShapeData>> shapes = discs::shapes_for(scene);
    if (!shapes)
        return shapes.problems();
    world->shapes = std::move(*shapes);
    for (const discs::ShapeData& data : world->shapes) {
        world->plain_shapes.push_back(data.shape);
        world->parts.push_back({data.material, nullptr, 0});
    }
    world->units = Units::of(scene, world->shapes);
    if (Problems problems = check_walls(*world); !problems.empty())
        return problems;
    open_box(*world);
    Result<std::vector<solver::FillState>> fills =
        solver::begin_fills(scene, solver::masses_of(world->plain_shapes), world->dt);
    if (!fills)
        return fills.problems();
    world->fills = std::move(*fills);
    if (auto problem = insert_due_fills(*world, tally))
        return *problem;
    if (stop_wanted(stop))
        return stopped_before_it_began();
    return world;
}

std::optional<Problem> insert(World& world, const std::vector<BodyState>& bodies) {
    if (auto problem = discs::refusal_of(bodies, world.scene))
        return problem;
    for (const BodyState& state : bodies) {
        world.bodies.push_back(put(world, state));
        world.shape.push_back(state.shape);
        world.inserted +=
            discs::energy_of(state, world.plain_shapes[static_cast<std::size_t>(state.shape)], world.scene.gravity);
    }
    world.books = account_of(world);
    return std::nullopt;
}

std::optional<Problem> advance(World& world, std::int64_t steps) {
    return solver::advance(world, steps);
}

} // namespace tumble::hard2d
