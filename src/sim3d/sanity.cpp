#include "sim3d/sanity.h"

#include "solver/sanity.h"

#include <Eigen/Core>
#include <algorithm>
#include <fmt/format.h>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;
using solver::name_of;
using solver::stop;

// rad; up to here the sine and cosine in kernels/integrate.cpp are right to 1e-7.
constexpr double widest_turn = 0.2;
double smallest_radius(const World& world, int slot) {
    const ShapeConstants& shape = world.shape_at(slot);
    double smallest = shape.exposed[3];
    for (int s = 1; s < shape.exposed_count; ++s)
        smallest = std::min(smallest, shape.exposed[4 * s + 3]);
    return smallest;
}

const char* const shorter_step = "use a shorter time step or stiffer materials, and look at the frames just before";

std::optional<Problem> wild_motion(const World& world) {
    for (int slot = 0; slot < world.bodies(); ++slot) {
        const BodyMotion& motion = world.motion[static_cast<std::size_t>(slot)];
        const double speed = Vector3d(motion.velocity).norm();
        const double spin = Vector3d(motion.spin).norm();
        if (!(speed + spin < 1e15))
            return stop(world, name_of(world, slot) + " has a velocity that is not a finite number", shorter_step);
        if (speed * world.dt > smallest_radius(world, slot))
            return stop(world,
                        fmt::format("{} moves at {:.4g} m/s, more than its smallest sphere's radius in one step",
                                    name_of(world, slot), speed),
                        shorter_step);
        if (spin * world.dt > widest_turn)
            return stop(world,
                        fmt::format("{} spins at {:.4g} rad/s, {:.2g} rad in one step where {} are the most",
                                    name_of(world, slot), spin, spin * world.dt, widest_turn),
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
                consider(c.overlap / c.radius, [&] {
                    const int wall = [&] {
                        for (const BodyWall& near : chunk.body_walls)
                            if (c.candidate >= near.begin && c.candidate < near.begin + near.count)
                                return near.wall;
                        return 0;
                    }();
                    return fmt::format("{} and wall '{}'", name_of(world, c.body),
                                       world.walls[static_cast<std::size_t>(wall)].wall.name);
                });
        for (const auto& contacts : chunk.body_contacts)
            for (const BodyContact& c : contacts)
                consider((c.radius_a + c.radius_b - Vector3d(c.d).norm()) / std::min(c.radius_a, c.radius_b),
                         [&] { return name_of(world, c.a) + " and " + name_of(world, c.b); });
        for (const NearSpheres& near : chunk.near_spheres)
            for (const NearPair& pair : near.pairs) {
                const BodyMotion& a = world.motion[static_cast<std::size_t>(pair.a)];
                const BodyMotion& b = world.motion[static_cast<std::size_t>(pair.b)];
                const Vector3d d = Vector3d(a.position) - Vector3d(b.position) -
                                   Vector3d(world.images[static_cast<std::size_t>(pair.image)].along);
                consider((a.radius + b.radius - d.norm()) / std::min(a.radius, b.radius),
                         [&] { return name_of(world, pair.a) + " and " + name_of(world, pair.b); });
            }
    }
    return who;
}

} // namespace

std::optional<Problem> insanity(const World& world) {
    if (auto problem = solver::leaping_wall(world, "sphere"))
        return problem;
    bool wild = false;
    for (const Chunk& chunk : world.chunks)
        wild = wild || !chunk.sums.motion.finite;
    if (wild || world.books.speed_max * world.dt > world.smallest_radius ||
        world.books.angular_speed_max * world.dt > widest_turn)
        if (auto problem = wild_motion(world))
            return problem;
    if (world.books.overlap_ratio_max > solver::deepest_overlap_ratio)
        return stop(world,
                    fmt::format("{} overlap by {:.3g} of the smaller sphere's radius", deepest_pair(world),
                                world.books.overlap_ratio_max),
                    "use stiffer materials, a shorter time step, or let the bodies come in more slowly");
    for (const Chunk& chunk : world.chunks)
        if (chunk.crossed_body >= 0)
            return stop(world,
                        fmt::format("{} went through wall '{}'", name_of(world, chunk.crossed_body),
                                    world.walls[static_cast<std::size_t>(chunk.crossed_wall)].wall.name),
                        "use a stiffer wall, a shorter time step, or let the bodies come in more slowly");
    if (world.step % solver::steps_per_look == 0)
        return solver::outside(
            world, [&](int slot) { return std::span(world.motion[static_cast<std::size_t>(slot)].position); });
    return std::nullopt;
}

} // namespace tumble::sim3d
