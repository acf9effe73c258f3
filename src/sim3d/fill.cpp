#include "sim3d/fill.h"

#include "scene/period.h"
#include "scene/written.h"
#include "sim3d/crowd.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

/// Uniform over all rotations (Shoemake 1992).
Eigen::Quaterniond random_orientation(Rng& rng) {
    const double u = rng.uniform();
    const double a = rng.uniform(0, 2 * std::numbers::pi);
    const double b = rng.uniform(0, 2 * std::numbers::pi);
    return {std::sqrt(1 - u) * std::sin(a), std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b),
            std::sqrt(u) * std::cos(b)};
}

bool inside_region(const World& world, const scene::Box& region, const Placement& body) {
    const ShapeConstants& shape = world.shape_constants[static_cast<std::size_t>(body.shape)];
    for (int s = 0; s < shape.exposed_count; ++s) {
        const double* sphere = shape.exposed + 4 * static_cast<std::ptrdiff_t>(s);
        const Vector3d centre = body.position + body.rotation * Vector3d(sphere[0], sphere[1], sphere[2]);
        for (int axis = 0; axis < 3; ++axis)
            if (!scene::spans_period(world.scene.domain, region, axis) &&
                (centre[axis] - sphere[3] < region.lo[axis] || centre[axis] + sphere[3] > region.hi[axis]))
                return false;
    }
    return true;
}

/// The key of a fill in the scene, for problems.
std::string key_of(const World& world, const FillState& fill, const std::string& name = "") {
    return fmt::format("fill.{}{}", &fill - world.fills.data(), name.empty() ? "" : "." + name);
}

const BodyShape& shape_of(const World& world, const FillState& fill) {
    return world.shapes[static_cast<std::size_t>(fill.fill.body)].shape;
}

BodyState state_of(const scene::Fill& fill, const Vector3d& position, const Eigen::Quaterniond& orientation) {
    BodyState state;
    state.shape = fill.body;
    state.position = position;
    state.orientation = orientation;
    state.velocity = fill.velocity;
    state.angular_velocity = fill.angular_velocity;
    return state;
}

std::vector<BodyState> place_at_random(const World& world, FillState& fill, Crowd& crowd, solver::PlacedCount& count) {
    const scene::Box& region = fill.fill.region;
    const Eigen::Quaterniond as_written = shape_of(world, fill).written_from_principal;
    std::vector<BodyState> placed;
    int misses = 0;
    while (fill.placed + static_cast<std::int64_t>(placed.size()) < fill.asked && misses < solver::misses_until_full &&
           !stop_wanted(world.stop)) {
        Vector3d position;
        for (int axis = 0; axis < 3; ++axis)
            position[axis] = fill.rng.uniform(region.lo[axis], region.hi[axis]);
        const Eigen::Quaterniond orientation =
            fill.fill.orientation == scene::Orientation::random ? random_orientation(fill.rng) : as_written;
        const Placement body{fill.fill.body, position, orientation.toRotationMatrix()};
        if (!inside_region(world, region, body) || wall_met(world, body) || !crowd.leaves_room_for(body)) {
            ++misses;
            continue;
        }
        misses = 0;
        crowd.add(body);
        placed.push_back(state_of(fill.fill, position, orientation));
        count.one_more();
    }
    return placed;
}

std::string owed(const World& world, const FillState& fill) {
    const Vector3d size = fill.fill.region.hi - fill.fill.region.lo;
    return fmt::format("asked for {} of body '{}' ({:.3g} m across), placed {} in the region of {:.4g} x {:.4g} x "
                       "{:.4g} m; {} did not fit",
                       fill.asked, shape_of(world, fill).name, 2 * shape_of(world, fill).bounding_radius, fill.placed,
                       size.x(), size.y(), size.z(), fill.asked - fill.placed);
}

/// A single body that is larger than the region is hardly one too many.
Problem does_not_fit(const World& world, const FillState& fill) {
    const double room = (fill.fill.region.hi - fill.fill.region.lo).minCoeff();
    const bool too_large = fill.placed == 0 && 2 * shape_of(world, fill).bounding_radius > room;
    return scene::problem_about(
        world.scene, key_of(world, fill), owed(world, fill),
        too_large ? "one body alone is larger than the region: look at the unit of its size, or enlarge the region"
                  : "enlarge the region, ask for fewer, or give until_s so that bodies come in over time");
}

Problem no_room_at(const World& world, const FillState& fill, const std::string& what_is_there) {
    const Vector3d& at = *fill.fill.position;
    return scene::problem_about(world.scene, key_of(world, fill, "position_m"),
                                fmt::format("body '{}' ({:.3g} m across) at ({:.6g}, {:.6g}, {:.6g}) m overlaps {} at "
                                            "t = {:.6g} s",
                                            shape_of(world, fill).name, 2 * shape_of(world, fill).bounding_radius,
                                            at.x(), at.y(), at.z(), what_is_there, world.time()),
                                "move it, or let it come at another time");
}

std::optional<Problem> insert_fill(World& world, FillState& fill, solver::PlacedCount& count) {
    std::vector<BodyState> placed;
    if (fill.fill.position) {
        const Eigen::Quaterniond orientation = fill.fill.orientation == scene::Orientation::random
                                                   ? random_orientation(fill.rng)
                                                   : shape_of(world, fill).written_from_principal;
        const Placement body{fill.fill.body, *fill.fill.position, orientation.toRotationMatrix()};
        if (const WallState* met = wall_met(world, body))
            return no_room_at(world, fill, fmt::format("wall '{}'", met->wall.name));
        if (!Crowd(world, 1).leaves_room_for(body))
            return no_room_at(world, fill, "another body");
        placed.push_back(state_of(fill.fill, *fill.fill.position, orientation));
        count.one_more();
    } else {
        const Rng before = fill.rng;
        Crowd crowd(world, fill.asked - fill.placed);
        placed = place_at_random(world, fill, crowd, count);
        if (stop_wanted(world.stop)) {
            fill.rng = before;
            return std::nullopt;
        }
    }
    fill.note(static_cast<std::int64_t>(placed.size()), world.step, world.dt);
    if (auto problem = insert(world, placed))
        return problem;
    if (!fill.failed())
        return std::nullopt;
    return does_not_fit(world, fill);
}

} // namespace

Problems prepare_fills(World& world) {
    Result<std::vector<FillState>> fills =
        solver::begin_fills(world.scene, solver::masses_of(world.plain_shapes), world.dt);
    if (!fills)
        return fills.problems();
    world.fills = std::move(*fills);
    world.next_fill_step = solver::next_due(world.fills);
    return {};
}

std::optional<Problem> insert_due_fills(World& world, const Tally& tally) {
    solver::PlacedCount count(world.fills, world.step, tally);
    for (FillState& fill : world.fills)
        if (fill.due(world.step) && !stop_wanted(world.stop))
            if (auto problem = insert_fill(world, fill, count))
                return problem;
    world.next_fill_step = solver::next_due(world.fills);
    return std::nullopt;
}

std::vector<std::string> unfilled(const World& world) {
    std::vector<std::string> reports;
    for (const FillState& fill : world.fills)
        if (fill.owes())
            reports.push_back(owed(world, fill));
    return reports;
}

} // namespace tumble::sim3d
