#include "sim3d/fill.h"

#include "base/cell_width.h"
#include "scene/period.h"
#include "scene/written.h"
#include "sim3d/placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

// A region counts as full after this many misses in a row.
constexpr int misses_until_full = 3000;

/// Uniform over all rotations (Shoemake 1992).
Eigen::Quaterniond random_orientation(Rng& rng) {
    const double u = rng.uniform();
    const double a = rng.uniform(0, 2 * std::numbers::pi);
    const double b = rng.uniform(0, 2 * std::numbers::pi);
    return {std::sqrt(1 - u) * std::sin(a), std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b),
            std::sqrt(u) * std::cos(b)};
}

/// Bodies by the cell of their bounding sphere, growing as bodies are placed. Between rebuilds a body may stand beyond
/// a periodic side; here all stand in the box.
class Crowd {
public:
    /// Room for the world's bodies and `more`.
    Crowd(const World& world, std::int64_t more) : world_(world) {
        double largest = 0;
        for (const ShapeConstants& shape : world.shape_constants)
            largest = std::max(largest, 2 * shape.bounding_radius);
        const Vector3d length = world.scene.domain.box.hi - world.scene.domain.box.lo;
        const double width =
            cell_width_for(length, largest, cells_per_body * (static_cast<double>(more) + world.bodies()) + 64);
        for (int k = 0; k < 3; ++k)
            size_[static_cast<std::size_t>(k)] = std::max(static_cast<int>(length[k] / width), 1);
        first_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), -1);
        for (int slot = 0; slot < world.bodies(); ++slot)
            add(placement_of(world, slot));
    }

    void add(const Placement& body) {
        const Placement inside = into_box(body);
        int& first = first_[index(place(bounding_centre(world_, inside)))];
        next_.push_back(first);
        first = static_cast<int>(bodies_.size());
        bodies_.push_back(inside);
    }

    [[nodiscard]] bool leaves_room_for(const Placement& body) const {
        const Placement inside = into_box(body);
        const Vector3d centre = bounding_centre(world_, inside);
        const std::array<int, 3> home = place(centre);
        std::array<int, 3> at{};
        for (at[0] = home[0] - 1; at[0] <= home[0] + 1; ++at[0])
            for (at[1] = home[1] - 1; at[1] <= home[1] + 1; ++at[1])
                for (at[2] = home[2] - 1; at[2] <= home[2] + 1; ++at[2])
                    if (!cell_leaves_room(inside, centre, at))
                        return false;
        return true;
    }

private:
    /// With its bounding centre in the box along periodic axes, wherever its centre of mass may be then.
    [[nodiscard]] Placement into_box(Placement body) const {
        const scene::Domain& domain = world_.scene.domain;
        const Vector3d centre = bounding_centre(world_, body);
        for (int axis = 0; axis < 3; ++axis)
            body.position[axis] -=
                scene::periods_past(domain, axis, centre[axis]) * (domain.box.hi[axis] - domain.box.lo[axis]);
        return body;
    }

    [[nodiscard]] bool cell_leaves_room(const Placement& body, const Vector3d& centre, std::array<int, 3> at) const {
        const scene::Domain& domain = world_.scene.domain;
        Vector3d shift = Vector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            if (at[k] >= 0 && at[k] < size_[k])
                continue;
            if (!domain.periodic[k])
                return true;
            const auto axis = static_cast<Eigen::Index>(k);
            const int turn = at[k] < 0 ? -1 : 1;
            shift[axis] = turn * (domain.box.hi[axis] - domain.box.lo[axis]);
            at[k] -= turn * size_[k];
        }
        const double own = world_.shape_constants[static_cast<std::size_t>(body.shape)].bounding_radius;
        for (int other = first_[index(at)]; other >= 0; other = next_[static_cast<std::size_t>(other)]) {
            const Placement& neighbour = bodies_[static_cast<std::size_t>(other)];
            const double reach =
                own + world_.shape_constants[static_cast<std::size_t>(neighbour.shape)].bounding_radius;
            if ((bounding_centre(world_, neighbour) + shift - centre).squaredNorm() < reach * reach &&
                overlap(world_, body, neighbour, shift))
                return false;
        }
        return true;
    }

    [[nodiscard]] std::array<int, 3> place(const Vector3d& centre) const {
        const scene::Box& box = world_.scene.domain.box;
        std::array<int, 3> at{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double part = (centre[axis] - box.lo[axis]) / (box.hi[axis] - box.lo[axis]);
            at[k] = std::clamp(static_cast<int>(std::floor(part * size_[k])), 0, size_[k] - 1);
        }
        return at;
    }

    [[nodiscard]] std::size_t index(const std::array<int, 3>& at) const {
        return static_cast<std::size_t>((at[0] * size_[1] + at[1]) * size_[2] + at[2]);
    }

    const World& world_;
    std::array<int, 3> size_{1, 1, 1};
    std::vector<int> first_; // per cell, of its bodies; -1: none
    std::vector<int> next_;  // per body, in its cell
    std::vector<Placement> bodies_;
};

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

std::vector<BodyState> place_at_random(const World& world, FillState& fill, Crowd& crowd) {
    const scene::Box& region = fill.fill.region;
    const Eigen::Quaterniond as_written = shape_of(world, fill).written_from_principal;
    std::vector<BodyState> placed;
    int misses = 0;
    while (fill.placed + static_cast<std::int64_t>(placed.size()) < fill.asked && misses < misses_until_full &&
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

void schedule(World& world) {
    world.next_fill_step = std::numeric_limits<std::int64_t>::max();
    for (const FillState& fill : world.fills)
        if (!fill.over)
            world.next_fill_step = std::min(world.next_fill_step, fill.next_step);
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

std::optional<Problem> insert_fill(World& world, FillState& fill) {
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
    } else {
        const Rng before = fill.rng;
        Crowd crowd(world, fill.asked - fill.placed);
        placed = place_at_random(world, fill, crowd);
        if (stop_wanted(world.stop)) {
            fill.rng = before;
            return std::nullopt;
        }
    }
    fill.begun = true;
    fill.placed += static_cast<std::int64_t>(placed.size());
    const double again = world.time() + fill.fill.every;
    fill.next_step = static_cast<std::int64_t>(std::ceil(again / world.dt));
    fill.over = fill.placed >= fill.asked || again > fill.fill.until;
    if (auto problem = insert(world, placed))
        return problem;
    if (fill.placed >= fill.asked || fill.fill.until > fill.fill.start)
        return std::nullopt;
    return does_not_fit(world, fill);
}

} // namespace

Problems prepare_fills(World& world) {
    Problems problems;
    for (const scene::Fill& fill : world.scene.fills) {
        FillState state{fill, Rng(world.scene.seed * 0x9e3779b97f4a7c15ULL + world.fills.size()), 0, 0, 0, false,
                        false};
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
        if (fill.begun && fill.placed < fill.asked)
            reports.push_back(owed(world, fill));
    return reports;
}

} // namespace tumble::sim3d
