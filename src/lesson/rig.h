#pragma once

#include "contact/disc_touch.h"

#include <cstddef>
#include <vector>

/// A rig that drags two grains along a prescribed path and writes down what their contact answers. No masses move, so
/// nothing but the law is seen.
namespace tumble::lesson {

/// A place of the rig, m: how deep one grain is pressed into the other, how far it is drawn along it.
struct Place {
    double overlap = 0, shear = 0;
};

struct Trace {
    std::vector<Place> place;
    std::vector<double> normal, shear; // N; shear as the rig has to pull
    double work_normal = 0;            // J, done by the rig, trapezoidal rule
    double work_shear = 0;
    double lost_sliding = 0;  // J, the law's own account
    double stored_normal = 0; // J, at the end
    double stored_shear = 0;
};

/// Goes from corner to corner in straight legs of `steps` steps, `dt` s each. `radius` is R* (m), `mass` m* (kg).
template <class Law>
Trace drag(const Law& law, double radius, double mass, const std::vector<Place>& corners, int steps, double dt) {
    Trace trace;
    contact::DiscMemory<double> memory{0, 0};
    Place at = corners.front();
    double normal = 0, shear = 0;
    const auto move_to = [&](const Place& next) {
        const double pressed = next.overlap - at.overlap, drawn = next.shear - at.shear;
        const contact::DiscTouch<double> touch{next.overlap, pressed / dt, drawn / dt, radius, mass};
        const contact::DiscPush<double> push = law.push(touch, memory, dt);
        trace.work_normal += 0.5 * (normal + push.normal) * pressed;
        trace.work_shear += 0.5 * (shear + push.shear) * drawn;
        trace.lost_sliding += push.lost_sliding;
        trace.stored_normal = push.stored_normal;
        trace.stored_shear = push.memory.energy;
        trace.place.push_back(next);
        trace.normal.push_back(normal = push.normal);
        trace.shear.push_back(shear = push.shear);
        memory = push.memory;
        at = next;
    };
    for (std::size_t leg = 1; leg < corners.size(); ++leg)
        for (int k = 1; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            const Place &from = corners[leg - 1], &to = corners[leg];
            move_to({from.overlap + share * (to.overlap - from.overlap), from.shear + share * (to.shear - from.shear)});
        }
    return trace;
}

} // namespace tumble::lesson
