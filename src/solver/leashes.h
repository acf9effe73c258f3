#pragma once

#include <algorithm>
#include <limits>
#include <vector>

/// How long lists of neighbours hold. Each thing that touches has an odometer, World::travel: a bound on how far it has
/// gone beside the mean flow. It starts with minus its leash, and lists hold until the first odometer shows 0.
namespace tumble::solver {

/// None is longer than this many half skins.
constexpr double longest_leash = 3;

/// Where an odometer stands at which nothing that was found out is valid any more.
constexpr double expired = std::numeric_limits<double>::lowest();

/// From speeds beside the mean flow, m/s, to odometers, m: the fast get long leashes, the slow short ones, so that all
/// last about as long; what a collision may add is the same for all. The mean is half a skin, m.
void start_odometers(std::vector<double>& travel, double skin);

/// Whether an odometer has run out, or a wall has gone further than its list allows.
template <class World> bool worn(const World& world) {
    double travelled = std::numeric_limits<double>::lowest();
    for (const auto& chunk : world.chunks)
        travelled = std::max(travelled, chunk.sums.motion.travel_max);
    double wall_travelled = 0;
    for (const auto& wall : world.walls)
        wall_travelled = std::max(wall_travelled, wall.travel);
    return travelled >= 0 || wall_travelled >= world.wall_skin;
}

/// How far two can have come closer in the last step, m.
template <class World> double closest_rush(const World& world) {
    double way = 0;
    for (const auto& chunk : world.chunks)
        way = std::max(way, chunk.sums.motion.way_max);
    return 2 * way;
}

} // namespace tumble::solver
