#include "scene/settled.h"

#include <algorithm>
#include <cmath>

namespace tumble::scene {

double slowest_period(const Scene& scene) {
    double period = 0;
    for (const Wall& wall : scene.walls)
        for (const Harmonic& part : wall.motion.harmonics)
            period = std::max(period, 1 / part.frequency);
    return period;
}

Stretch driven(const Scene& scene) {
    Stretch stretch{0, scene.duration};
    bool moves = false;
    const auto take = [&](const auto& parts) {
        for (const auto& part : parts) {
            moves = true;
            stretch.from = std::max(stretch.from, part.active.start);
            stretch.until = std::min(stretch.until, part.active.stop);
        }
    };
    for (const Wall& wall : scene.walls) {
        take(wall.motion.harmonics);
        take(wall.motion.rotations);
        take(wall.motion.rockings);
        take(wall.motion.linears);
        take(wall.motion.tables);
    }
    for (const Fill& fill : scene.fills)
        if (!moves)
            stretch.from = std::max(stretch.from, fill.until);
    return stretch;
}

Stretch settled(const Scene& scene) {
    Stretch stretch = driven(scene);
    const double half = (stretch.until - stretch.from) / 2, pair = 2 * slowest_period(scene);
    const double whole = pair > 0 ? std::floor(half / pair + 1e-9) * pair : half;
    stretch.from = stretch.until - (whole > 0 ? whole : half);
    return stretch;
}

} // namespace tumble::scene
