#include "sim3d/step.h"

namespace tumble::sim3d {

namespace {

PushContext context_of(World& world, Chunk& chunk, std::size_t kind) {
    PushContext context{};
    context.motion = world.motion.data();
    context.load = world.load.data();
    context.begin = chunk.begin;
    context.end = chunk.end;
    context.images = world.images.data();
    context.dt = world.dt;
    context.pair = world.pairs[kind];
    context.normal_law = static_cast<int>(world.scene.contact.normal);
    context.tangential_law = static_cast<int>(world.scene.contact.tangential);
    context.limit_force = world.scene.contact.limit_force;
    context.sums = &chunk.sums.contacts;
    return context;
}

void prepare_foreign(Chunk& chunk, PushContext& context, int contacts) {
    if (chunk.foreign.size() < static_cast<std::size_t>(contacts))
        chunk.foreign.resize(static_cast<std::size_t>(contacts) * 2);
    context.foreign = chunk.foreign.data();
    context.foreign_count = 0;
}

void post(const World& world, Chunk& chunk, const PushContext& context) {
    for (int k = 0; k < context.foreign_count; ++k) {
        const ForeignPush& push = chunk.foreign[static_cast<std::size_t>(k)];
        chunk.outbox[static_cast<std::size_t>(world.chunk_of[static_cast<std::size_t>(push.body)])].push_back(push);
    }
}

} // namespace

void push_contacts(World& world, Chunk& chunk) {
    chunk.sums.contacts = {};
    chunk.sums.contacts.lost_history = chunk.dropped_history;
    chunk.sums.contacts.lost_adhesion = chunk.dropped_adhesion;
    for (auto& letters : chunk.outbox)
        letters.clear();
    for (std::size_t kind = 0; kind < world.pairs.size(); ++kind) {
        PushContext context = context_of(world, chunk, kind);
        const bool plain = context.pair.plain();
        if (NearSpheres& near = chunk.near_spheres[kind]; near.contact_count > 0) {
            prepare_foreign(chunk, context, near.contact_count);
            context.further = plain ? nullptr : near.further.data();
            world.kernels->push_spheres(context, near.pairs.data(), near.contacts.data(), near.contact_count,
                                        near.memory.data());
            post(world, chunk, context);
        }
        if (const auto& contacts = chunk.body_contacts[kind]; !contacts.empty()) {
            prepare_foreign(chunk, context, static_cast<int>(contacts.size()));
            context.further = plain ? nullptr : chunk.candidates.further.data();
            world.kernels->push_bodies(context, contacts.data(), static_cast<int>(contacts.size()),
                                       chunk.candidates.memory.data());
            post(world, chunk, context);
        }
        if (auto& contacts = chunk.wall_contacts[kind]; !contacts.empty()) {
            context.further = plain ? nullptr : chunk.wall_further.data();
            world.kernels->push_walls(context, contacts.data(), static_cast<int>(contacts.size()));
            for (const WallContact& contact : contacts)
                chunk.wall_candidates[static_cast<std::size_t>(contact.candidate)]
                    .memory[static_cast<std::size_t>(contact.touch)]
                    .lanes = contact.memory;
        }
    }
}

void collect_pushes(World& world, Chunk& chunk) {
    const auto own = static_cast<std::size_t>(&chunk - world.chunks.data());
    for (std::size_t sender = 0; sender < world.chunks.size(); ++sender) {
        if ((chunk.partners_before & chunk_bit(static_cast<int>(sender))) == 0)
            continue;
        for (const ForeignPush& push : world.chunks[sender].outbox[own]) {
            BodyLoad& load = world.load[static_cast<std::size_t>(push.body)];
            for (int axis = 0; axis < 3; ++axis) {
                load.force[axis] += push.force[axis];
                load.torque[axis] += push.torque[axis];
            }
        }
    }
}

} // namespace tumble::sim3d
