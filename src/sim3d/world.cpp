#include "sim3d/world.h"

#include "sim3d/fill.h"
#include "sim3d/sanity.h"
#include "sim3d/step.h"
#include "solver/advance.h"
#include "solver/sanity.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

BodyTurn turn_of(const ShapeConstants& shape, const BodyState& state) {
    BodyTurn turn{};
    const Eigen::Matrix3d rotation =
        shape.single ? Eigen::Matrix3d::Identity() : state.orientation.normalized().toRotationMatrix();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{turn.rotation} = rotation;
    const Vector3d inertia(shape.inertia);
    Eigen::Map<Vector3d>{turn.momentum} =
        rotation * inertia.cwiseProduct(rotation.transpose() * state.angular_velocity);
    return turn;
}

BodyOrientation orientation_of(const BodyState& state) {
    const Eigen::Quaterniond q = state.orientation.normalized();
    return {{q.w(), q.x(), q.y(), q.z()}};
}

BodyMotion motion_of(const ShapeConstants& shape, const BodyState& state) {
    BodyMotion motion{};
    Eigen::Map<Vector3d>{motion.position} = state.position;
    Eigen::Map<Vector3d>{motion.velocity} = state.velocity;
    Eigen::Map<Vector3d>{motion.spin} = state.angular_velocity;
    motion.radius = shape.single ? shape.exposed[3] : 0;
    motion.mass = shape.mass;
    motion.kick = 0.5;
    return motion;
}

double energy_of(const World& world, const ShapeConstants& shape, const BodyState& state, const BodyTurn& turn) {
    return 0.5 * shape.mass * state.velocity.squaredNorm() + 0.5 * Vector3d(turn.momentum).dot(state.angular_velocity) -
           shape.mass * world.scene.gravity.dot(state.position);
}

std::optional<Problem> refusal_of(const World& world, const BodyState& state, std::size_t number) {
    const bool finite = state.position.allFinite() && state.velocity.allFinite() &&
                        state.angular_velocity.allFinite() && state.orientation.coeffs().allFinite() &&
                        state.orientation.norm() >= 0.5;
    const double at[] = {state.position.x(), state.position.y(), state.position.z()};
    return solver::refusal_of(number, state.shape,
                              finite ? nullptr : "has a number that is not finite, or no orientation", at, world.scene);
}

} // namespace

void WorldDeleter::operator()(World* world) const {
    delete world;
}

std::optional<Problem> insert(World& world, const std::vector<BodyState>& bodies) {
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (auto problem = refusal_of(world, bodies[k], k))
            return problem;
    world.newcomers.add(static_cast<std::int64_t>(world.id.size()), world.step);
    for (const BodyState& state : bodies) {
        const ShapeConstants& shape = world.shape_constants[static_cast<std::size_t>(state.shape)];
        const BodyTurn turn = turn_of(shape, state);
        world.slot_of.push_back(world.bodies());
        world.id.push_back(static_cast<std::int64_t>(world.id.size()));
        world.shape.push_back(state.shape);
        world.motion.push_back(motion_of(shape, state));
        world.orientation.push_back(orientation_of(state));
        world.turn.push_back(turn);
        world.load.push_back({});
        world.travel.push_back(0);
        world.ledger.inserted += energy_of(world, shape, state, turn);
    }
    world.stale = world.stale || !bodies.empty();
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

namespace {

// Leapfrog's spins are half a step behind; the last known torque brings them up to date.
Vector3d spin_at_step(const World& world, std::size_t slot) {
    const BodyTurn& turn = world.turn[slot];
    const Vector3d inertia(world.shape_at(static_cast<int>(slot)).inertia);
    const Vector3d kick = 0.5 * world.dt * Vector3d(world.load[slot].torque);
    if (world.shape_at(static_cast<int>(slot)).single)
        return Vector3d(world.motion[slot].spin) + kick / inertia[0];
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(turn.rotation);
    return rotation * (rotation.transpose() * (Vector3d(turn.momentum) + kick)).cwiseQuotient(inertia);
}

} // namespace

std::vector<BodyState> bodies_of(const World& world) {
    std::vector<BodyState> bodies(world.id.size());
    for (std::size_t slot = 0; slot < world.id.size(); ++slot) {
        const BodyMotion& motion = world.motion[slot];
        const BodyLoad& load = world.load[slot];
        const double* q = world.orientation[slot].q;
        BodyState& state = bodies[static_cast<std::size_t>(world.id[slot])];
        state.id = world.id[slot];
        state.shape = world.shape[slot];
        state.position = Vector3d(motion.position);
        state.orientation = {q[0], q[1], q[2], q[3]};
        state.velocity = Vector3d(motion.velocity) + 0.5 * world.dt / motion.mass * Vector3d(load.force);
        state.angular_velocity = spin_at_step(world, slot);
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

} // namespace tumble::sim3d
