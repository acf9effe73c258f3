#include "sim2d/sanity.h"

#include "solver/sanity.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::sim2d {

namespace {

using solver::stop;

std::string name_of(const World& world, int row) {
    return solver::name_of(world, world.slot_of(row));
}

const char* const shorter_step = "use a shorter time step or stiffer contacts, and look at the frames just before";

/// m, from the centre of mass to the farthest middle of a disc, or a little more; 0 for a lone disc.
double arm_of(const ShapeConstants& shape) {
    return shape.single ? 0 : shape.reach - shape.smallest_radius;
}

double longest_arm(const World& world) {
    double arm = 0;
    for (const ShapeConstants& shape : world.shape_constants)
        arm = std::max(arm, arm_of(shape));
    return arm;
}

std::optional<Problem> wild_motion(const World& world) {
    for (int slot = 0; slot < world.bodies(); ++slot) {
        const Row& row = world.row(slot);
        const double speed = std::hypot(row.vx, row.vy);
        if (!(speed + std::abs(row.spin) < 1e15))
            return stop(world, name_of(world, slot) + " has a velocity that is not a finite number", shorter_step);
        const ShapeConstants& shape = world.shape_at(slot);
        if (speed * world.dt > shape.smallest_radius)
            return stop(world,
                        fmt::format("{} moves at {:.4g} m/s, more than its smallest disc's radius in one step",
                                    name_of(world, slot), speed),
                        shorter_step);
        const double whirl = std::abs(row.spin) * arm_of(shape);
        if ((speed + whirl) * world.dt > shape.smallest_radius)
            return stop(
                world,
                fmt::format("{} moves at {:.4g} m/s and spins at {:.4g} rad/s: its discs go further than the smallest "
                            "one's radius in one step",
                            name_of(world, slot), speed, std::abs(row.spin)),
                shorter_step);
    }
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

} // namespace

std::optional<Problem> insanity(const World& world) {
    bool wild = false;
    for (const Chunk& chunk : world.chunks)
        wild = wild || !chunk.sums.motion.finite;
    const double fastest = world.books.speed_max + world.books.angular_speed_max * longest_arm(world); // m/s, at most
    if (wild || fastest * world.dt > world.smallest_radius)
        if (auto problem = wild_motion(world))
            return problem;
    if (world.books.overlap_ratio_max > solver::deepest_overlap_ratio)
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
    if (auto problem = solver::leaping_wall(world, "disc"))
        return problem;
    if (world.step % solver::steps_per_look == 0)
        return solver::outside(world, [&](int slot) { return std::array{world.row(slot).x, world.row(slot).y}; });
    return std::nullopt;
}

} // namespace tumble::sim2d
