#include "sim2d/world.h"

#include "sim2d/fill.h"
#include "sim2d/sanity.h"
#include "sim2d/step.h"

#include <cmath>
#include <fmt/format.h>

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

double energy_of(const World& world, const ShapeConstants& shape, const BodyState& state) {
    return 0.5 * shape.mass * state.velocity.squaredNorm() +
           0.5 * shape.inertia * state.angular_velocity * state.angular_velocity -
           shape.mass * world.scene.gravity.head<2>().dot(state.position);
}

std::optional<Problem> refuse(const World& world, const BodyState& state, std::size_t number) {
    const auto problem = [&](const std::string& what, const std::string& fix) {
        return Problem{world.scene.file.string(), 0, 0, "", fmt::format("body {} to insert {}", number + 1, what), fix};
    };
    if (state.shape < 0 || state.shape >= static_cast<int>(world.shapes.size()))
        return problem(fmt::format("names shape {}, of {}", state.shape, world.shapes.size()), "give an index from 0");
    if (!state.position.allFinite() || !state.velocity.allFinite() || !std::isfinite(state.angular_velocity) ||
        !std::isfinite(state.angle))
        return problem("has a number that is not finite", "check where the state comes from");
    const scene::Domain& domain = world.scene.domain;
    for (int k = 0; k < 2; ++k)
        if (!domain.periodic[static_cast<std::size_t>(k)] &&
            (state.position[k] < domain.box.lo[k] || state.position[k] > domain.box.hi[k]))
            return problem(fmt::format("stands at {} = {:.6g} m, outside the domain", "xy"[k], state.position[k]),
                           "enlarge the domain or move the body");
    return std::nullopt;
}

} // namespace

void WorldDeleter::operator()(World* world) const {
    delete world;
}

std::optional<Problem> insert(World& world, const std::vector<BodyState>& bodies) {
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (auto problem = refuse(world, bodies[k], k))
            return problem;
    if (bodies.empty())
        return std::nullopt;
    // Rows of clumps' discs make room for the new bodies; what contacts remember is taken while the rows still stand.
    if (!world.stale)
        world.kept.take(world);
    world.stale = true;
    world.rows.resize(world.id.size());
    world.loads.resize(world.id.size());
    for (const BodyState& state : bodies) {
        const ShapeConstants& shape = world.shape_constants[static_cast<std::size_t>(state.shape)];
        world.id.push_back(static_cast<std::int64_t>(world.id.size()));
        world.shape.push_back(state.shape);
        world.angle.push_back(state.angle);
        world.rows.push_back(row_of(shape, state));
        world.loads.push_back({});
        world.first_tag.push_back(world.tags);
        world.tags += shape.exposed_count;
        world.ledger.inserted += energy_of(world, shape, state);
    }
    return std::nullopt;
}

std::optional<Problem> advance(World& world, std::int64_t steps) {
    for (std::int64_t k = 0; k < steps; ++k) {
        if (world.step >= world.next_fill_step) {
            if (auto problem = insert_due_fills(world))
                return problem;
            if (stop_wanted(world.stop))
                return std::nullopt;
        }
        step(world);
        if (auto problem = insanity(world))
            return problem;
    }
    return std::nullopt;
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
    std::vector<PhaseTime> phases;
    for (std::size_t k = 0; k < phase_names.size(); ++k) {
        double seconds = world.seconds[k];
        for (const Chunk& chunk : world.chunks)
            seconds += chunk.seconds[k];
        phases.push_back({phase_names[k], seconds});
    }
    return phases;
}

} // namespace tumble::sim2d
