#include "sim2d/sanity.h"

#include "sim2d/mean_flow.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::sim2d {

namespace {

using Eigen::Vector2d;

constexpr double deepest_overlap_ratio = 1.0;
// Leaving the domain harms nothing at once, so positions are looked at only so often.
constexpr std::int64_t steps_per_look = 50;

std::string name_of(const World& world, int row) {
    const auto slot = static_cast<std::size_t>(world.slot_of(row));
    return fmt::format("body {} ({})", world.id[slot],
                       world.shapes[static_cast<std::size_t>(world.shape[slot])].shape.name);
}

Problem stop(const World& world, const std::string& what, const std::string& fix) {
    return {world.scene.file.string(),
            0,
            0,
            "",
            fmt::format("stopped at t = {:.6g} s, step {}: {}", world.time(), world.step, what),
            fix};
}

const char* const shorter_step = "use a shorter time step or stiffer contacts, and look at the frames just before";

std::optional<Problem> wild_motion(const World& world) {
    for (int slot = 0; slot < world.bodies(); ++slot) {
        const Row& row = world.row(slot);
        const double speed = std::hypot(row.vx, row.vy);
        if (!(speed + std::abs(row.spin) < 1e15))
            return stop(world, name_of(world, slot) + " has a velocity that is not a finite number", shorter_step);
        if (speed * world.dt > world.shape_at(slot).smallest_radius)
            return stop(world,
                        fmt::format("{} moves at {:.4g} m/s, more than its smallest disc's radius in one step",
                                    name_of(world, slot), speed),
                        shorter_step);
    }
    return std::nullopt;
}

/// A wall that goes further than a radius in a step could pass a disc that touches it neither before nor after, so that
/// no crossing is seen.
std::optional<Problem> leaping_wall(const World& world) {
    for (const WallState& wall : world.walls)
        if (wall.leap > world.smallest_radius)
            return stop(world,
                        fmt::format("wall '{}' moves by {:.3g} m in one step, more than the smallest disc's radius",
                                    wall.wall.name, wall.leap),
                        "use a shorter time step or a slower wall");
    return std::nullopt;
}

std::string deepest_pair(const World& world) {
    double deepest = 0;
    std::string who = "two bodies";
    const auto consider = [&](double ratio, auto&& name) {
        if (ratio > deepest) {
            deepest = ratio;
            who = name();
        }
    };
    for (const Chunk& chunk : world.chunks) {
        for (const auto& contacts : chunk.wall_contacts)
            for (const WallContact& c : contacts)
                consider(c.overlap / world.row(c.row).radius, [&] {
                    const int wall = chunk.wall_nears[static_cast<std::size_t>(c.near)].wall;
                    return fmt::format("{} and wall '{}'", name_of(world, c.row),
                                       world.walls[static_cast<std::size_t>(wall)].wall.name);
                });
        for (const NearDiscs& near : chunk.near_discs)
            for (const NearPair& pair : near.pairs) {
                const Row& a = world.row(pair.a);
                const Row& b = world.row(pair.b);
                const auto& shift = world.images[static_cast<std::size_t>(pair.image)].along;
                consider((a.radius + b.radius - std::hypot(a.x - b.x - shift[0], a.y - b.y - shift[1])) /
                             std::min(a.radius, b.radius),
                         [&] { return name_of(world, pair.a) + " and " + name_of(world, pair.b); });
            }
    }
    return who;
}

std::optional<Problem> outside(const World& world) {
    const scene::Domain& domain = world.scene.domain;
    for (int slot = 0; slot < world.bodies(); ++slot)
        for (int k = 0; k < 2; ++k) {
            const double x = k == 0 ? world.row(slot).x : world.row(slot).y;
            if (!domain.periodic[static_cast<std::size_t>(k)] && (x < domain.box.lo[k] || x > domain.box.hi[k]))
                return stop(
                    world, fmt::format("{} left the domain at {} = {:.4g} m", name_of(world, slot), "xy"[k], x),
                    "enlarge the domain, close the walls, or make them stiffer so that nothing is pushed through");
        }
    return std::nullopt;
}

} // namespace

std::optional<Problem> insanity(const World& world) {
    bool wild = false;
    for (const Chunk& chunk : world.chunks)
        wild = wild || !chunk.sums.motion.finite;
    if (wild || world.books.speed_max * world.dt > world.smallest_radius)
        if (auto problem = wild_motion(world))
            return problem;
    if (world.books.overlap_ratio_max > deepest_overlap_ratio)
        return stop(world,
                    fmt::format("{} overlap by {:.3g} of the smaller disc's radius", deepest_pair(world),
                                world.books.overlap_ratio_max),
                    "use stiffer contacts, a shorter time step, or let the bodies come in more slowly");
    for (const Chunk& chunk : world.chunks)
        if (chunk.crossed_row >= 0)
            return stop(world,
                        fmt::format("{} went through wall '{}'", name_of(world, chunk.crossed_row),
                                    world.walls[static_cast<std::size_t>(chunk.crossed_wall)].wall.name),
                        "use a stiffer wall, a shorter time step, or let the bodies come in more slowly");
    if (auto problem = leaping_wall(world))
        return problem;
    if (world.step % steps_per_look == 0)
        return outside(world);
    return std::nullopt;
}

} // namespace tumble::sim2d
