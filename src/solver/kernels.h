#pragma once

#include <cstdint>

/// What the hot loops of both dimensions hand over, as plain numbers; each solver's kernels.h says what they are for.
namespace tumble::solver {

/// A listed pair that touches or soon may.
struct NearPair {
    int a;
    int b;
    int image;
    int listed; // index of its pair in the list of all
};

/// A shift of the periodic box, m; the fourth is unused.
struct alignas(32) Shift {
    double along[4];
};

struct TouchCounts {
    int contacts;
    int ended;
};

struct ContactSums {
    double stored_normal = 0;
    double stored_tangential = 0;
    double stored_rolling = 0;
    double lost_normal_damping = 0;
    double lost_tangential_damping = 0;
    double lost_sliding = 0;
    double lost_rolling_damping = 0; // by power
    double lost_rolling_sliding = 0; // exact
    double lost_adhesion = 0;
    double lost_history = 0;
    double wall_work = 0; // J in this step
    double overlap_max = 0;
    double overlap_ratio_max = 0;
    std::int64_t contacts = 0;
};

struct MotionSums {
    double kinetic_translation = 0;
    double kinetic_rotation = 0;
    double gravity = 0;
    double lost_global_damping = 0; // J in this step
    double travel_max = -1e300;
    double way_max = 0; // m, the longest that any odometer advanced
    double speed_squared_max = 0;
    double spin_squared_max = 0;
    bool finite = true;
};

} // namespace tumble::solver
