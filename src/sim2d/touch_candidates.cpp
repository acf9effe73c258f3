#include "sim2d/step.h"

#include <algorithm>
#include <cmath>
#include <numbers>
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

void make_room(std::vector<int>& list, std::size_t entries) {
    if (list.size() < entries)
        list.resize(2 * entries);
}

void touch_discs(const World& world, Chunk& chunk, NearDiscs& near) {
    make_room(near.contacts, near.pairs.size() + 1);
    make_room(chunk.found, near.pairs.size() + 1);
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

// Pieces that meet at less than this stand for one curved line.
const double cos_smooth_joint = std::cos(30 * std::numbers::pi / 180);

/// The touch that goes on with what `old` remembers: the one with the same feature, else, over a joint, one that was
/// not there before and faces nearly the same way. Null if there is none.
WallMemory* heir_of(const WallMemory& old, std::span<WallMemory> now, std::span<const WallMemory> before) {
    for (WallMemory& memory : now)
        if (memory.feature == old.feature)
            return &memory;
    for (WallMemory& memory : now) {
        const bool fresh = std::none_of(before.begin(), before.end(),
                                        [&](const WallMemory& other) { return other.feature == memory.feature; });
        if (fresh && memory.memory.energy == 0 && memory.normal.dot(old.normal) > cos_smooth_joint)
            return &memory;
    }
    return nullptr;
}

/// Hands the memory of the touches a step ago to those of now; what finds no heir is forgotten, and what is new starts
/// at rest. `further` holds what the touches remember beside it, or is null.
void match_features(Chunk& chunk, WallNear& near, FurtherMemory* further, std::span<const WallTouch> touches) {
    std::array<WallMemory, max_wall_touches> now;
    std::array<FurtherMemory, max_wall_touches> further_now{};
    for (std::size_t t = 0; t < touches.size(); ++t)
        now[t] = {touches[t].feature, touches[t].normal, {}};
    const std::span before(near.memory.data(), static_cast<std::size_t>(near.touches));
    for (std::size_t t = 0; t < before.size(); ++t) {
        WallMemory& old = before[t];
        WallMemory* heir = heir_of(old, {now.data(), touches.size()}, before);
        if (heir)
            heir->memory = old.memory;
        else
            forget(chunk, old.memory);
        if (further && heir)
            further_now[static_cast<std::size_t>(heir - now.data())] = further[t];
        else if (further)
            forget(chunk, further[t]);
    }
    if (further)
        std::copy(further_now.begin(), further_now.end(), further);
    near.memory = now;
    near.touches = static_cast<int>(touches.size());
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
    match_features(
        chunk, near,
        world.remembers_more ? &chunk.wall_further[static_cast<std::size_t>(max_wall_touches * which)] : nullptr, now);
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
