#include "sim2d/step.h"
#include "solver/arrays.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace tumble::sim2d {

namespace {

using Eigen::Vector2d;

void forget(Chunk& chunk, Memory& memory) {
    chunk.dropped_history += memory.energy;
    memory = {};
}

void forget(Chunk& chunk, FurtherMemory& further) {
    chunk.dropped_history += further.rolling_energy;
    further = {};
}

void touch_discs(const World& world, Chunk& chunk, NearDiscs& near) {
    solver::make_room(near.contacts, near.pairs.size() + 1);
    solver::make_room(chunk.found, near.pairs.size() + 1);
    const TouchCounts counts =
        world.kernels->touch_discs(world.rows.data(), near.pairs.data(), static_cast<int>(near.pairs.size()),
                                   world.images.data(), near.touching.data(), near.contacts.data(), chunk.found.data());
    near.contact_count = counts.contacts;
    for (int k = 0; k < counts.ended; ++k) {
        const auto ended = static_cast<std::size_t>(chunk.found[static_cast<std::size_t>(k)]);
        forget(chunk, near.memory[ended]);
        if (world.remembers_more)
            forget(chunk, near.further[ended]);
    }
}

/// Whether the disc's centre has passed through the line in the last step, as the wall saw it: the way from where it
/// stood a step ago, through the middle of the step, to here.
bool crosses(const WallState& wall, const Row& row, double dt, std::span<const WallTouch> touches,
             std::span<const int> pieces) {
    const Vector2d here(row.x, row.y);
    const Vector2d now = wall.frame.to_wall(here);
    const Vector2d middle = wall.half_frame.to_wall(here - 0.5 * dt * Vector2d(row.vx, row.vy));
    const Vector2d way = 2 * (now - middle);
    double nearest = row.radius;
    for (const WallTouch& touch : touches)
        nearest = std::min(nearest, row.radius + touch.gap);
    return way.squaredNorm() >= nearest * nearest && wall.line.crossed(now - way, now, pieces);
}

WallContact wall_contact(const WallState& wall, const Row& row, const WallTouch& touch) {
    WallContact contact{};
    contact.overlap = -touch.gap;
    const Vector2d normal = wall.frame.rotation * touch.normal;
    const Vector2d point = Vector2d(row.x, row.y) - normal * (row.radius - 0.5 * contact.overlap);
    contact.spin = wall.half_frame.spin;
    Eigen::Map<Vector2d>{contact.normal} = normal;
    Eigen::Map<Vector2d>{contact.velocity} = wall.half_frame.velocity_at(point);
    Eigen::Map<Vector2d>{contact.now} = wall.frame.velocity_at(point);
    return contact;
}

void touch_wall(const World& world, Chunk& chunk, int which) {
    WallNear& near = chunk.wall_nears[static_cast<std::size_t>(which)];
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const Row& row = world.row(near.row);
    std::array<WallTouch, max_wall_touches> touches;
    const std::span<const int> pieces(chunk.wall_pieces.data() + near.pieces_begin,
                                      static_cast<std::size_t>(near.pieces_count));
    const int count = wall.line.touches(wall.frame.to_wall({row.x, row.y}), row.radius, pieces, touches);
    const std::span<const WallTouch> now(touches.data(), static_cast<std::size_t>(count));
    if (count == 0 && near.touches == 0)
        return;
    if (crosses(wall, row, world.dt, now, pieces)) {
        chunk.crossed_row = near.row;
        chunk.crossed_wall = near.wall;
    }
    solver::match_features(
        near.memory, near.touches,
        world.remembers_more ? &chunk.wall_further[static_cast<std::size_t>(max_wall_touches * which)] : nullptr, now,
        [&](auto& lost) { forget(chunk, lost); });
    const int kind = world.kind_of(near.row, wall.wall.material);
    for (int t = 0; t < count; ++t) {
        WallContact contact = wall_contact(wall, row, touches[static_cast<std::size_t>(t)]);
        contact.row = near.row;
        contact.near = which;
        contact.touch = t;
        contact.memory = near.memory[static_cast<std::size_t>(t)].memory;
        chunk.wall_contacts[static_cast<std::size_t>(kind)].push_back(contact);
    }
}

} // namespace

void touch_candidates(World& world, Chunk& chunk) {
    chunk.dropped_history = 0;
    for (NearDiscs& near : chunk.near_discs)
        touch_discs(world, chunk, near);
    for (auto& list : chunk.wall_contacts)
        list.clear();
    for (int k = 0; k < static_cast<int>(chunk.wall_nears.size()); ++k)
        if (chunk.wall_nears[static_cast<std::size_t>(k)].awake)
            touch_wall(world, chunk, k);
}

} // namespace tumble::sim2d
