#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <string>

/// What no state may be like, and how a run that came to it says so.
namespace tumble::solver {

constexpr double deepest_overlap_ratio = 1.0; // of the smaller radius
// Leaving the domain harms nothing at once, so positions are looked at only so often.
constexpr std::int64_t steps_per_look = 50;

/// Why a run ends at the world's step.
template <class World> Problem stop(const World& world, const std::string& what, const std::string& fix) {
    return {world.scene.file.string(),
            0,
            0,
            "",
            fmt::format("stopped at t = {:.6g} s, step {}: {}", world.time(), world.step, what),
            fix};
}

/// The body in that slot, for a sentence.
template <class World> std::string name_of(const World& world, int slot) {
    const auto at = static_cast<std::size_t>(slot);
    return fmt::format("body {} ({})", world.id[at],
                       world.plain_shapes[static_cast<std::size_t>(world.shape[at])].name);
}

/// A wall that goes further than a radius in a step could pass a part, "disc" or "sphere", that touches it neither
/// before nor after, so that no crossing is seen.
template <class World> std::optional<Problem> leaping_wall(const World& world, const char* part) {
    for (const auto& wall : world.walls)
        if (wall.leap > world.smallest_radius)
            return stop(world,
                        fmt::format("wall '{}' moves by {:.3g} m in one step, more than the smallest {}'s radius",
                                    wall.wall.name, wall.leap, part),
                        "use a shorter time step or a slower wall");
    return std::nullopt;
}

/// The first axis along which the place, m, lies outside the domain and not just past a periodic side.
std::optional<int> axis_outside(const scene::Domain& domain, std::span<const double> place);

/// A body that has left the domain; place_of(slot) is its place, m.
template <class World, class PlaceOf> std::optional<Problem> outside(const World& world, PlaceOf&& place_of) {
    for (int slot = 0; slot < world.bodies(); ++slot) {
        const auto place = place_of(slot);
        if (const auto axis = axis_outside(world.scene.domain, place))
            return stop(world,
                        fmt::format("{} left the domain at {} = {:.4g} m", name_of(world, slot), "xyz"[*axis],
                                    place[static_cast<std::size_t>(*axis)]),
                        "enlarge the domain, close the walls, or make them stiffer so that nothing is pushed through");
    }
    return std::nullopt;
}

/// Why a body cannot be put into the scene's world: a shape index that does not exist, the flaw ("has ...") of its
/// state if there is one, a place (m) outside the domain. `number` counts the bodies to insert from 0.
std::optional<Problem> refusal_of(std::size_t number, int shape, const char* flaw, std::span<const double> place,
                                  const scene::Scene& scene);

} // namespace tumble::solver
