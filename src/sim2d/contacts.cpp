#include "sim2d/step.h"
#include "solver/asked_again.h"

#include <vector>

/// The kernels keep what contacts do together in sums. Who wants to know it singly, and that is once a frame, asks the
/// law again: with the last step's geometry and velocities, and springs that no time passes for, it answers the same.
namespace tumble::sim2d {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d in_space(const Vector2d& v) {
    return {v.x(), v.y(), 0};
}

/// What integrate.cpp kicked, before.
double velocity_before(const World& world, double after, double acceleration, double kick) {
    const double half = 0.5 * world.scene.contact.global_damping * world.dt;
    return (after * (1 + half) - acceleration * world.dt * kick) / (1 - half * (2 * kick - 1));
}

/// A body as the last step found it: what leapfrog did is taken back.
Row body_before(const World& world, int slot) {
    Row row = world.row(slot);
    const auto at = static_cast<std::size_t>(slot);
    const Load& load = world.loads[at];
    row.kick = world.newcomers.kick_before(world.id[at], world.step);
    row.x -= world.dt * row.vx;
    row.y -= world.dt * row.vy;
    row.vx = velocity_before(world, row.vx, load.fx / row.mass, row.kick);
    row.vy = velocity_before(world, row.vy, load.fy / row.mass, row.kick);
    row.spin = velocity_before(world, row.spin, load.torque / world.shape_at(slot).inertia, row.kick);
    return row;
}

Row row_before(const World& world, int at) {
    const int slot = world.slot_of(at);
    const auto body = static_cast<std::size_t>(slot);
    const Row before = body_before(world, slot);
    if (at == slot)
        return before;
    const ShapeConstants& shape = world.shape_at(slot);
    std::vector<Row> discs(static_cast<std::size_t>(shape.exposed_count));
    place_discs(shape, before, world.angle[body] - world.dt * world.row(slot).spin, discs.data());
    return discs[static_cast<std::size_t>(at - world.first_disc[body])];
}

Memory nudged(Memory memory) {
    memory.kept = solver::nudged(memory.kept);
    return memory;
}

FurtherMemory nudged(FurtherMemory further) {
    further.rolling = solver::nudged(further.rolling);
    return further;
}

/// Lets push(context) push contacts of one pair of materials that have `rows` of their own; the loads of these.
template <class Push>
Lines<Load> loads_of(const World& world, std::size_t kind, const Lines<Row>& rows, std::vector<FurtherMemory>& further,
                     Push&& push) {
    Lines<Load> loads(rows.size(), Load{});
    ContactSums sums;
    PushContext context = law_of(world, kind);
    context.dt = 0;
    context.rows = rows.data();
    context.loads = loads.data();
    context.owned = {0, static_cast<int>(rows.size()), 0, 0};
    context.further = context.pair.plain() ? nullptr : further.data();
    context.sums = &sums;
    push(context);
    return loads;
}

std::int64_t id_of(const World& world, int row) {
    return world.id[static_cast<std::size_t>(world.slot_of(row))];
}

void add_discs(const World& world, const Chunk& chunk, std::size_t kind, std::vector<ContactPush>& pushes) {
    const NearDiscs& near = chunk.near_discs[kind];
    Lines<Row> rows;
    std::vector<Memory> memory;
    std::vector<FurtherMemory> further;
    std::vector<NearPair> pairs;
    std::vector<int> which;
    for (int k = 0; k < near.contact_count; ++k) {
        const auto at = static_cast<std::size_t>(near.contacts[static_cast<std::size_t>(k)]);
        rows.push_back(row_before(world, near.pairs[at].a));
        rows.push_back(row_before(world, near.pairs[at].b));
        memory.push_back(nudged(near.memory[at]));
        if (!world.pairs[kind].plain())
            further.push_back(nudged(near.further[at]));
        pairs.push_back({2 * k, 2 * k + 1, near.pairs[at].image, near.pairs[at].listed});
        which.push_back(k);
    }
    const Lines<Load> loads = loads_of(world, kind, rows, further, [&](PushContext& context) {
        world.kernels->push_discs(context, pairs.data(), which.data(), near.contact_count, memory.data());
    });
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const Row& a = rows[2 * k];
        const Row& b = rows[2 * k + 1];
        const NearPair& pair = near.pairs[static_cast<std::size_t>(near.contacts[k])];
        const auto& image = world.images[static_cast<std::size_t>(pair.image)].along;
        const Vector2d d(a.x - b.x - image[0], a.y - b.y - image[1]);
        const Vector2d normal = d.normalized();
        const double reach = a.radius - 0.5 * (a.radius + b.radius - d.norm());
        pushes.push_back({.a = id_of(world, pair.a),
                          .b = id_of(world, pair.b),
                          .point = in_space(Vector2d(a.x, a.y) - reach * normal),
                          .normal = in_space(normal),
                          .force = {loads[2 * k].fx, loads[2 * k].fy, 0}});
    }
}

void add_walls(const World& world, const Chunk& chunk, std::size_t kind, std::vector<ContactPush>& pushes) {
    std::vector<WallContact> contacts = chunk.wall_contacts[kind];
    Lines<Row> rows;
    std::vector<FurtherMemory> further;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        WallContact& contact = contacts[k];
        if (!world.pairs[kind].plain()) {
            further.resize((k + 1) * max_wall_touches);
            further[k * max_wall_touches] =
                nudged(chunk.wall_further[static_cast<std::size_t>(contact.near * max_wall_touches + contact.touch)]);
        }
        rows.push_back(row_before(world, contact.row));
        contact.memory = nudged(contact.memory);
        contact.row = contact.near = static_cast<int>(k);
        contact.touch = 0;
    }
    const Lines<Load> loads = loads_of(world, kind, rows, further, [&](PushContext& context) {
        world.kernels->push_walls(context, contacts.data(), static_cast<int>(contacts.size()));
    });
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const WallContact& own = chunk.wall_contacts[kind][k];
        const Vector2d normal(own.normal);
        const Vector2d point = Vector2d(rows[k].x, rows[k].y) - normal * (rows[k].radius - 0.5 * own.overlap);
        pushes.push_back({.a = id_of(world, own.row),
                          .wall = chunk.wall_nears[static_cast<std::size_t>(own.near)].wall,
                          .point = in_space(point),
                          .normal = in_space(normal),
                          .force = {loads[k].fx, loads[k].fy, 0}});
    }
}

} // namespace

std::vector<ContactPush> contacts_of(const World& world) {
    std::vector<ContactPush> pushes;
    for (const Chunk& chunk : world.chunks)
        for (std::size_t kind = 0; kind < world.pairs.size(); ++kind) {
            add_discs(world, chunk, kind, pushes);
            add_walls(world, chunk, kind, pushes);
        }
    solver::drop_idle(pushes);
    return pushes;
}

} // namespace tumble::sim2d
