#include "scene/settled.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::scene {

Vibration slowest_vibration(const Scene& scene) {
    Vibration slowest;
    const auto take = [&](const auto& parts) {
        for (const auto& part : parts)
            if (1 / part.frequency > slowest.period)
                slowest = {1 / part.frequency,
                           part.active.start - part.phase / (2 * std::numbers::pi * part.frequency)};
    };
    for (const Wall& wall : scene.walls) {
        take(wall.motion.harmonics);
        take(wall.motion.rockings);
    }
    return slowest;
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
    const double half = (stretch.until - stretch.from) / 2, pair = 2 * slowest_vibration(scene).period;
    const double whole = pair > 0 ? std::floor(half / pair + 1e-9) * pair : half;
    stretch.from = stretch.until - (whole > 0 ? whole : half);
    return stretch;
}

} // namespace tumble::scene
