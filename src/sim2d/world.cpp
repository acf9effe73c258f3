#include "sim2d/world.h"

#include "sim2d/fill.h"
#include "sim2d/sanity.h"
#include "sim2d/step.h"
#include "solver/advance.h"

namespace tumble::sim2d {

using Eigen::Vector2d;

namespace {

Row row_of(const ShapeConstants& shape, const BodyState& state) {
    return {state.position.x(),
            state.position.y(),
            shape.single ? shape.exposed[2] : 0.0,
            shape.mass,
            state.velocity.x(),
            state.velocity.y(),
            state.angular_velocity,
            0.5};
}

} // namespace

void WorldDeleter::operator()(World* world) const {
    delete world;
}

std::optional<Problem> insert(World& world, const std::vector<BodyState>& bodies) {
    if (auto problem = discs::refusal_of(bodies, world.scene))
        return problem;
    if (bodies.empty())
        return std::nullopt;
    // Rows of clumps' discs make room for the new bodies; what contacts remember is taken while the rows still stand.
    if (!world.stale)
        world.kept.take(world);
    world.stale = true;
    world.rows.resize(world.id.size());
    world.loads.resize(world.id.size());
    world.newcomers.add(static_cast<std::int64_t>(world.id.size()), world.step);
    for (const BodyState& state : bodies) {
        const ShapeConstants& shape = world.shape_constants[static_cast<std::size_t>(state.shape)];
        world.id.push_back(static_cast<std::int64_t>(world.id.size()));
        world.shape.push_back(state.shape);
        world.angle.push_back(state.angle);
        world.rows.push_back(row_of(shape, state));
        world.loads.push_back({});
        world.first_tag.push_back(world.tags);
        world.tags += shape.exposed_count;
        world.ledger.inserted +=
            discs::energy_of(state, world.plain_shapes[static_cast<std::size_t>(state.shape)], world.scene.gravity);
    }
    return std::nullopt;
}

std::optional<Problem> advance(World& world, std::int64_t steps) {
    return solver::advance(world, steps);
}

double time_of(const World& world) {
    return world.time();
}

std::int64_t steps_of(const World& world) {
    return world.step;
}

Books books_of(const World& world) {
    return world.step > 0 ? world.books : opening_books(world);
}

const std::vector<BodyShape>& shapes_of(const World& world) {
    return world.plain_shapes;
}

std::vector<BodyState> bodies_of(const World& world) {
    std::vector<BodyState> bodies(world.id.size());
    for (std::size_t slot = 0; slot < world.id.size(); ++slot) {
        const Row& row = world.rows[slot];
        const Load& load = world.loads[slot];
        const ShapeConstants& shape = world.shape_at(static_cast<int>(slot));
        // Leapfrog's velocities are half a step behind; the last known force brings them up to date.
        const double half = 0.5 * world.dt;
        const double kept = row.kick < 1 ? 1.0 : 1 - half * world.scene.contact.global_damping;
        BodyState& state = bodies[static_cast<std::size_t>(world.id[slot])];
        state.id = world.id[slot];
        state.shape = world.shape[slot];
        state.position = {row.x, row.y};
        state.angle = world.angle[slot];
        state.velocity = kept * Vector2d(row.vx, row.vy) + half / row.mass * Vector2d(load.fx, load.fy);
        state.angular_velocity = kept * row.spin + half / shape.inertia * load.torque;
    }
    return bodies;
}

std::vector<scene::WallPose> walls_of(const World& world) {
    std::vector<scene::WallPose> poses;
    for (const WallState& wall : world.walls)
        poses.push_back(scene::pose_at(wall.wall.motion, world.time()));
    return poses;
}

std::vector<PhaseTime> phase_times(const World& world) {
    return solver::phase_times(world);
}

} // namespace tumble::sim2d
