#include "run/fill_plan.h"

#include <cmath>
#include <numeric>

namespace tumble::run {

std::vector<std::int64_t> bodies_wanted(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies) {
    std::vector<std::int64_t> wanted;
    for (const scene::Fill& fill : scene.fills) {
        const double mass = bodies[static_cast<std::size_t>(fill.body)].mass;
        wanted.push_back(fill.count ? *fill.count : std::llround(fill.mass.value_or(0) / mass));
    }
    return wanted;
}

std::int64_t all_bodies_wanted(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies) {
    const std::vector<std::int64_t> wanted = bodies_wanted(scene, bodies);
    return std::accumulate(wanted.begin(), wanted.end(), std::int64_t{0});
}

} // namespace tumble::run
