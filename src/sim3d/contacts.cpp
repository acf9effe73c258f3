#include "sim3d/step.h"
#include "solver/asked_again.h"

#include <Eigen/Geometry>

/// The kernels keep what contacts do together in sums. Who wants to know it singly, and that is once a frame, asks the
/// law again: with the last step's geometry and velocities, and springs that no time passes for, it answers the same.
namespace tumble::sim3d {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d rotation_by(const Vector3d& way) {
    const double angle = way.norm();
    return angle > 0 ? Eigen::AngleAxisd(angle, way / angle).toRotationMatrix() : Matrix3d::Identity();
}

/// rad/s, of a body with that angular momentum in that orientation.
Vector3d spin_of(const Matrix3d& rotation, const ShapeConstants& shape, const Vector3d& momentum) {
    return rotation * (rotation.transpose() * momentum).cwiseQuotient(Vector3d(shape.inertia));
}

/// rad/s, of a clump, with the share of a kick that the step gave. Its spin is that of its momentum midway through the
/// step before, which began where this very spin leads from: sought by trying again, and each try is closer by the
/// angle of a step.
Vector3d clump_spin_before(const World& world, std::size_t at, const ShapeConstants& shape, double share) {
    const BodyTurn& turn = world.turn[at];
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> after(turn.rotation);
    const Matrix3d standing = rotation_by(-world.dt * Vector3d(world.motion[at].spin)) * after;
    const Vector3d momentum = Vector3d(turn.momentum) - world.dt * share * Vector3d(world.load[at].torque);
    Vector3d spin = spin_of(standing, shape, momentum);
    if (share < 1)
        return spin; // as it was inserted
    constexpr int most_tries = 20;
    for (int k = 0; k < most_tries; ++k) {
        const Matrix3d start = rotation_by(-world.dt * spin) * standing;
        const Matrix3d midway = rotation_by(0.5 * world.dt * spin_of(start, shape, momentum)) * start;
        const Vector3d better = spin_of(midway, shape, momentum);
        const double change = (better - spin).norm();
        spin = better;
        if (!(change > 1e-15 * spin.norm()))
            break;
    }
    return spin;
}

/// As the last step found it: what leapfrog did is taken back.
BodyMotion motion_before(const World& world, int slot) {
    const auto at = static_cast<std::size_t>(slot);
    BodyMotion motion = world.motion[at];
    const ShapeConstants& shape = world.shape_at(slot);
    const double share = world.newcomers.kick_before(world.id[at], world.step);
    const double kicked = world.dt * share; // s
    const Vector3d spin =
        shape.single ? Vector3d(Vector3d(motion.spin) - kicked / shape.inertia[0] * Vector3d(world.load[at].torque))
                     : clump_spin_before(world, at, shape, share);
    for (int axis = 0; axis < 3; ++axis) {
        motion.position[axis] -= world.dt * motion.velocity[axis];
        motion.velocity[axis] -= kicked / motion.mass * world.load[at].force[axis];
        motion.spin[axis] = spin[axis];
    }
    motion.kick = share;
    return motion;
}

/// Contacts of one pair of materials, each with two bodies of its own, so that what it does can be read off their
/// loads.
struct Apart {
    Lines<BodyMotion> motion;
    std::vector<MemoryLanes> memory;
    std::vector<FurtherLanes> further;

    void add(const World& world, int a, int b, const MemoryLanes& remembered, const FurtherLanes* more) {
        motion.push_back(motion_before(world, a));
        motion.push_back(motion_before(world, b));
        MemoryLanes& kept = memory.emplace_back(remembered);
        for (double& stretch : kept.spring)
            stretch = solver::nudged(stretch);
        if (!more)
            return;
        FurtherLanes& turned = further.emplace_back(*more);
        for (double& stretch : turned.rolling)
            stretch = solver::nudged(stretch);
    }

    /// Lets push(context) push them all; N on the first body of each.
    template <class Push> std::vector<Vector3d> forces(const World& world, std::size_t kind, Push&& push) {
        Lines<BodyLoad> load(motion.size(), BodyLoad{});
        ContactSums sums;
        PushContext context = law_of(world, kind);
        context.dt = 0;
        context.motion = motion.data();
        context.load = load.data();
        context.end = static_cast<int>(motion.size());
        context.further = context.pair.plain() ? nullptr : further.data();
        context.sums = &sums;
        push(context);
        std::vector<Vector3d> forces;
        for (std::size_t k = 0; k < load.size(); k += 2)
            forces.emplace_back(load[k].force);
        return forces;
    }
};

/// `d` m, from b's sphere to a's, whose centre is `centre`.
ContactPush between(const World& world, int a, int b, const Vector3d& centre, const Vector3d& d, double radius_a,
                    double radius_b, const Vector3d& force) {
    const Vector3d normal = d.normalized();
    return {.a = world.id[static_cast<std::size_t>(a)],
            .b = world.id[static_cast<std::size_t>(b)],
            .point = centre - normal * (radius_a - 0.5 * (radius_a + radius_b - d.norm())),
            .normal = normal,
            .force = force};
}

void add_spheres(const World& world, const Chunk& chunk, std::size_t kind, std::vector<ContactPush>& pushes) {
    const NearSpheres& near = chunk.near_spheres[kind];
    const bool plain = world.pairs[kind].plain();
    Apart apart;
    std::vector<NearPair> pairs;
    std::vector<int> which;
    for (int k = 0; k < near.contact_count; ++k) {
        const auto at = static_cast<std::size_t>(near.contacts[static_cast<std::size_t>(k)]);
        apart.add(world, near.pairs[at].a, near.pairs[at].b, near.memory[at], plain ? nullptr : &near.further[at]);
        pairs.push_back({2 * k, 2 * k + 1, near.pairs[at].image, near.pairs[at].listed});
        which.push_back(k);
    }
    const std::vector<Vector3d> forces = apart.forces(world, kind, [&](PushContext& context) {
        world.kernels->push_spheres(context, pairs.data(), which.data(), near.contact_count, apart.memory.data());
    });
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const BodyMotion& a = apart.motion[2 * k];
        const BodyMotion& b = apart.motion[2 * k + 1];
        const NearPair& pair = near.pairs[static_cast<std::size_t>(near.contacts[k])];
        const Vector3d d = Vector3d(a.position) - Vector3d(b.position) -
                           Vector3d(world.images[static_cast<std::size_t>(pair.image)].along);
        pushes.push_back(between(world, pair.a, pair.b, Vector3d(a.position), d, a.radius, b.radius, forces[k]));
    }
}

void add_clumps(const World& world, const Chunk& chunk, std::size_t kind, std::vector<ContactPush>& pushes) {
    const bool plain = world.pairs[kind].plain();
    Apart apart;
    std::vector<BodyContact> contacts = chunk.body_contacts[kind];
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        BodyContact& contact = contacts[k];
        const auto at = static_cast<std::size_t>(contact.memory);
        apart.add(world, contact.a, contact.b, chunk.candidates.memory[at],
                  plain ? nullptr : &chunk.candidates.further[at]);
        contact.a = static_cast<int>(2 * k);
        contact.b = contact.a + 1;
        contact.memory = static_cast<int>(k);
    }
    const std::vector<Vector3d> forces = apart.forces(world, kind, [&](PushContext& context) {
        world.kernels->push_bodies(context, contacts.data(), static_cast<int>(contacts.size()), apart.memory.data());
    });
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const BodyContact& own = chunk.body_contacts[kind][k];
        const Vector3d centre = Vector3d(apart.motion[2 * k].position) + Vector3d(own.arm_a);
        pushes.push_back(between(world, own.a, own.b, centre, Vector3d(own.d), own.radius_a, own.radius_b, forces[k]));
    }
}

/// Of each wall candidate, whose it is.
std::vector<int> walls_of_candidates(const Chunk& chunk) {
    std::vector<int> walls(chunk.wall_candidates.size(), -1);
    for (const BodyWall& near : chunk.body_walls)
        for (int k = near.begin; k < near.begin + near.count; ++k)
            walls[static_cast<std::size_t>(k)] = near.wall;
    return walls;
}

void add_walls(const World& world, const Chunk& chunk, std::vector<ContactPush>& pushes) {
    const std::vector<int> walls = walls_of_candidates(chunk);
    for (const std::vector<WallContact>& contacts : chunk.wall_contacts)
        for (const WallContact& contact : contacts) {
            const Vector3d normal(contact.normal);
            const Vector3d centre = Vector3d(motion_before(world, contact.body).position) + Vector3d(contact.arm);
            pushes.push_back({.a = world.id[static_cast<std::size_t>(contact.body)],
                              .wall = walls[static_cast<std::size_t>(contact.candidate)],
                              .point = centre - normal * (contact.radius - 0.5 * contact.overlap),
                              .normal = normal,
                              .force = Vector3d(contact.force)});
        }
}

} // namespace

std::vector<ContactPush> contacts_of(const World& world) {
    std::vector<ContactPush> pushes;
    for (const Chunk& chunk : world.chunks) {
        for (std::size_t kind = 0; kind < world.pairs.size(); ++kind) {
            add_spheres(world, chunk, kind, pushes);
            add_clumps(world, chunk, kind, pushes);
        }
        add_walls(world, chunk, pushes);
    }
    solver::drop_idle(pushes);
    return pushes;
}

} // namespace tumble::sim3d
