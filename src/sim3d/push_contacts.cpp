#include "sim3d/step.h"

namespace tumble::sim3d {

namespace {

PushContext context_of(World& world, Chunk& chunk, std::size_t kind) {
    PushContext context = law_of(world, kind);
    context.motion = world.motion.data();
    context.load = world.load.data();
    context.begin = chunk.begin;
    context.end = chunk.end;
    context.sums = &chunk.sums.contacts;
    return context;
}

} // namespace

PushContext law_of(const World& world, std::size_t kind) {
    PushContext context{};
    context.images = world.images.data();
    context.dt = world.dt;
    Eigen::Map<Eigen::Vector3d>{context.gravity} = world.scene.gravity;
    context.pair = world.pairs[kind];
    context.normal_law = static_cast<int>(world.scene.contact.normal);
    context.tangential_law = static_cast<int>(world.scene.contact.tangential);
    context.limit_force = world.scene.contact.limit_force;
    return context;
}

void push_contacts(World& world, Chunk& chunk) {
    chunk.sums.contacts = {};
    chunk.sums.contacts.lost_history = chunk.dropped_history;
    chunk.sums.contacts.lost_adhesion = chunk.dropped_adhesion;
    chunk.foreign_count = 0;
    for (std::size_t kind = 0; kind < world.pairs.size(); ++kind) {
        if (chunk.near_spheres[kind].contact_count == 0 && chunk.body_contacts[kind].empty() &&
            chunk.wall_contacts[kind].empty())
            continue;
        PushContext context = context_of(world, chunk, kind);
        const bool plain = context.pair.plain();
        if (NearSpheres& near = chunk.near_spheres[kind]; near.contact_count > 0) {
            context.further = plain ? nullptr : near.further.data();
            solver::push_with_letters(chunk, context, near.contact_count, [&] {
                world.kernels->push_spheres(context, near.pairs.data(), near.contacts.data(), near.contact_count,
                                            near.memory.data());
            });
        }
        if (const auto& contacts = chunk.body_contacts[kind]; !contacts.empty()) {
            const auto count = static_cast<int>(contacts.size());
            context.further = plain ? nullptr : chunk.candidates.further.data();
            solver::push_with_letters(chunk, context, count, [&] {
                world.kernels->push_bodies(context, contacts.data(), count, chunk.candidates.memory.data());
            });
        }
        if (auto& contacts = chunk.wall_contacts[kind]; !contacts.empty()) {
            context.further = plain ? nullptr : chunk.wall_further.data();
            world.kernels->push_walls(context, contacts.data(), static_cast<int>(contacts.size()));
            for (const WallContact& contact : contacts)
                chunk.wall_candidates[static_cast<std::size_t>(contact.candidate)]
                    .memory[static_cast<std::size_t>(contact.touch)]
                    .memory = contact.memory;
        }
    }
}

void collect_pushes(World& world, Chunk& chunk) {
    solver::read_letters(world.chunks, chunk, [&](const ForeignPush& push) {
        if (push.body < chunk.begin || push.body >= chunk.end)
            return;
        BodyLoad& load = world.load[static_cast<std::size_t>(push.body)];
        for (int axis = 0; axis < 3; ++axis) {
            load.force[axis] += push.force[axis];
            load.torque[axis] += push.torque[axis];
        }
    });
}

} // namespace tumble::sim3d
