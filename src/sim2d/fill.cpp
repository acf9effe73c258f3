#include "sim2d/fill.h"

#include "scene/written.h"
#include "sim2d/crowd.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace tumble::sim2d {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A region counts as full after this many misses in a row.
constexpr int misses_until_full = 3000;

double angle_for(FillState& fill) {
    return fill.fill.orientation == scene::Orientation::random ? fill.rng.uniform(0, 2 * std::numbers::pi) : 0.0;
}

bool spans_period(const scene::Domain& domain, const scene::Box& region, int axis) {
    return domain.periodic[static_cast<std::size_t>(axis)] && region.lo[axis] <= domain.box.lo[axis] &&
           region.hi[axis] >= domain.box.hi[axis];
}

bool inside_region(const World& world, const scene::Box& region, const std::vector<Disc>& discs) {
    for (const Disc& disc : discs)
        for (int axis = 0; axis < 2; ++axis)
            if (!spans_period(world.scene.domain, region, axis) && (disc.centre[axis] - disc.radius < region.lo[axis] ||
                                                                    disc.centre[axis] + disc.radius > region.hi[axis]))
                return false;
    return true;
}

BodyState state_of(const scene::Fill& fill, const Placement& body) {
    BodyState state;
    state.shape = fill.body;
    state.position = body.position;
    state.angle = body.angle;
    state.velocity = fill.velocity.head<2>();
    state.angular_velocity = fill.angular_velocity.z();
    return state;
}

std::vector<BodyState> place_at_random(const World& world, FillState& fill, Crowd& crowd) {
    const scene::Box& region = fill.fill.region;
    std::vector<BodyState> placed;
    int misses = 0;
    while (fill.placed + static_cast<std::int64_t>(placed.size()) < fill.asked && misses < misses_until_full &&
           !stop_wanted(world.stop)) {
        Placement body{fill.fill.body, {}, 0};
        for (int axis = 0; axis < 2; ++axis)
            body.position[axis] = fill.rng.uniform(region.lo[axis], region.hi[axis]);
        body.angle = angle_for(fill);
        const std::vector<Disc> discs = discs_of(world, body);
        if (!inside_region(world, region, discs) || in_wall(world, discs) || !crowd.leaves_room_for(discs)) {
            ++misses;
            continue;
        }
        misses = 0;
        crowd.add(discs);
        placed.push_back(state_of(fill.fill, body));
    }
    return placed;
}

/// The key of a fill in the scene, for problems.
std::string key_of(const World& world, const FillState& fill, const std::string& name = "") {
    return fmt::format("fill.{}{}", &fill - world.fills.data(), name.empty() ? "" : "." + name);
}

std::string owed(const World& world, const FillState& fill) {
    const Vector3d size = fill.fill.region.hi - fill.fill.region.lo;
    return fmt::format("asked for {} of body '{}', placed {} in the region of {:.4g} x {:.4g} m; {} did not fit",
                       fill.asked, world.shapes[static_cast<std::size_t>(fill.fill.body)].shape.name, fill.placed,
                       size.x(), size.y(), fill.asked - fill.placed);
}

void schedule(World& world) {
    world.next_fill_step = std::numeric_limits<std::int64_t>::max();
    for (const FillState& fill : world.fills)
        if (!fill.over)
            world.next_fill_step = std::min(world.next_fill_step, fill.next_step);
}

Problem no_room_at(const World& world, const FillState& fill, const char* what_is_there) {
    const Vector3d& at = *fill.fill.position;
    return scene::problem_about(world.scene, key_of(world, fill, "position_m"),
                                fmt::format("body '{}' at ({:.6g}, {:.6g}) m overlaps {} at t = {:.6g} s",
                                            world.shapes[static_cast<std::size_t>(fill.fill.body)].shape.name, at.x(),
                                            at.y(), what_is_there, world.time()),
                                "move it, or let it come at another time");
}

std::optional<Problem> insert_fill(World& world, FillState& fill) {
    std::vector<BodyState> placed;
    const std::int64_t bodies = fill.fill.position ? 1 : fill.asked - fill.placed;
    const auto& shape = world.shape_constants[static_cast<std::size_t>(fill.fill.body)];
    Crowd crowd(world, bodies * shape.exposed_count);
    if (fill.fill.position) {
        const Placement body{fill.fill.body, fill.fill.position->head<2>(), angle_for(fill)};
        const std::vector<Disc> discs = discs_of(world, body);
        if (in_wall(world, discs))
            return no_room_at(world, fill, "a wall");
        if (!crowd.leaves_room_for(discs))
            return no_room_at(world, fill, "another body");
        placed.push_back(state_of(fill.fill, body));
    } else {
        const Rng before = fill.rng;
        placed = place_at_random(world, fill, crowd);
        if (stop_wanted(world.stop)) {
            fill.rng = before;
            return std::nullopt;
        }
    }
    fill.placed += static_cast<std::int64_t>(placed.size());
    const double again = world.time() + fill.fill.every;
    fill.next_step = static_cast<std::int64_t>(std::ceil(again / world.dt));
    fill.over = fill.placed >= fill.asked || again > fill.fill.until;
    if (auto problem = insert(world, placed))
        return problem;
    if (fill.placed >= fill.asked || fill.fill.until > fill.fill.start)
        return std::nullopt;
    return scene::problem_about(world.scene, key_of(world, fill), owed(world, fill),
                                "enlarge the region, ask for fewer, or give until_s so that bodies come in over time");
}

} // namespace

Problems prepare_fills(World& world) {
    Problems problems;
    for (const scene::Fill& fill : world.scene.fills) {
        FillState state{fill, Rng(world.scene.seed * 0x9e3779b97f4a7c15ULL + world.fills.size()), 0, 0, 0, false};
        const double mass = world.shapes[static_cast<std::size_t>(fill.body)].shape.mass;
        state.asked = fill.count ? *fill.count : std::llround(fill.mass.value_or(0) / mass);
        state.next_step = static_cast<std::int64_t>(std::ceil(fill.start / world.dt - 1e-9));
        if (state.asked < 1)
            problems.push_back(
                scene::problem_about(world.scene, fmt::format("fill.{}.mass_kg", world.fills.size()),
                                     fmt::format("a fill asks for less than one body of {:.4g} kg", mass),
                                     "ask for more mass, or give a count"));
        world.fills.push_back(std::move(state));
    }
    schedule(world);
    return problems;
}

std::optional<Problem> insert_due_fills(World& world) {
    for (FillState& fill : world.fills)
        if (!fill.over && fill.next_step <= world.step && !stop_wanted(world.stop))
            if (auto problem = insert_fill(world, fill))
                return problem;
    schedule(world);
    return std::nullopt;
}

std::vector<std::string> unfilled(const World& world) {
    std::vector<std::string> reports;
    for (const FillState& fill : world.fills)
        if (fill.placed < fill.asked && (fill.over || fill.placed > 0))
            reports.push_back(owed(world, fill));
    return reports;
}

} // namespace tumble::sim2d
