#include "sim2d/step.h"

namespace tumble::sim2d {

namespace {

PushContext context_of(World& world, Chunk& chunk, std::size_t kind) {
    PushContext context = law_of(world, kind);
    context.rows = world.rows.data();
    context.loads = world.loads.data();
    context.owned = chunk.owned;
    context.sums = &chunk.sums.contacts;
    return context;
}

/// What the discs of the chunk's clumps got goes to their bodies.
void hand_on(World& world, const Chunk& chunk) {
    for (int disc = chunk.owned.disc_begin; disc < chunk.owned.disc_end; ++disc) {
        const int slot = world.slot_of(disc);
        const Load& got = world.loads[static_cast<std::size_t>(disc)];
        Load& load = world.loads[static_cast<std::size_t>(slot)];
        const double arm_x = world.row(disc).x - world.row(slot).x;
        const double arm_y = world.row(disc).y - world.row(slot).y;
        load.fx += got.fx;
        load.fy += got.fy;
        load.torque += got.torque + arm_x * got.fy - arm_y * got.fx;
    }
}

} // namespace

PushContext law_of(const World& world, std::size_t kind) {
    PushContext context{};
    context.images = world.images.data();
    context.periodic = world.scene.domain.periodic[0] || world.scene.domain.periodic[1];
    context.dt = world.dt;
    Eigen::Map<Eigen::Vector2d>{context.gravity} = world.scene.gravity.head<2>();
    context.pair = world.pairs[kind];
    context.normal_law = static_cast<int>(world.scene.contact.normal);
    context.tangential_law = static_cast<int>(world.scene.contact.tangential);
    context.limit_force = world.scene.contact.limit_force;
    return context;
}

void push_contacts(World& world, Chunk& chunk) {
    chunk.sums.contacts = {};
    chunk.sums.contacts.lost_history = chunk.dropped_history;
    chunk.foreign_count = 0;
    for (std::size_t kind = 0; kind < world.pairs.size(); ++kind) {
        if (chunk.near_discs[kind].contact_count == 0 && chunk.wall_contacts[kind].empty())
            continue;
        PushContext context = context_of(world, chunk, kind);
        const bool plain = context.pair.plain();
        if (NearDiscs& near = chunk.near_discs[kind]; near.contact_count > 0) {
            context.further = plain ? nullptr : near.further.data();
            solver::push_with_letters(chunk, context, near.contact_count, [&] {
                world.kernels->push_discs(context, near.pairs.data(), near.contacts.data(), near.contact_count,
                                          near.memory.data());
            });
        }
        if (auto& contacts = chunk.wall_contacts[kind]; !contacts.empty()) {
            context.further = plain ? nullptr : chunk.wall_further.data();
            world.kernels->push_walls(context, contacts.data(), static_cast<int>(contacts.size()));
            for (const WallContact& contact : contacts)
                chunk.wall_nears[static_cast<std::size_t>(contact.near)]
                    .memory[static_cast<std::size_t>(contact.touch)]
                    .memory = contact.memory;
        }
    }
}

void collect_pushes(World& world, Chunk& chunk) {
    solver::read_letters(world.chunks, chunk, [&](const ForeignPush& push) {
        if (!owns(chunk.owned, push.row))
            return;
        Load& load = world.loads[static_cast<std::size_t>(push.row)];
        load.fx += push.fx;
        load.fy += push.fy;
        load.torque += push.torque;
    });
    hand_on(world, chunk);
}

} // namespace tumble::sim2d
