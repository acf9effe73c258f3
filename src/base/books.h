#pragma once

#include "base/carried.h"

#include <cstdint>

namespace tumble {

/// The solver's own account of one instant, as plain numbers (J where not said otherwise).
/// kinetic + gravity + stored + lost = start + inserted + wall_work, up to `closure`.
struct Books {
    double time = 0; // s
    std::int64_t step = 0;
    std::int64_t bodies = 0;
    std::int64_t contacts = 0; // touching sphere pairs, walls included
    double kinetic_translation = 0;
    double kinetic_rotation = 0;
    double gravity = 0; // potential, relative to the origin
    double stored_normal = 0;
    double stored_tangential = 0;
    double stored_rolling = 0;
    double lost_normal_damping = 0;
    double lost_tangential_damping = 0;
    double lost_sliding = 0;
    double lost_rolling = 0; // by resistance against rolling
    double lost_history = 0; // spring energy that the law drops when it projects, restiffens or forgets a history
    double lost_global_damping = 0; // by mass-proportional damping of bodies
    double lost_air_drag = 0;       // to still air
    double lost_adhesion = 0;       // with necks of adhesion that tore
    bool splits_losses = true;      // false: of losses only the sum is known, as what the balance lacks
    double lost_in_sum = 0;         // then
    double wall_work = 0;           // done by walls on bodies
    double inserted = 0;            // energy that came with inserted bodies
    double closure = 0;             // left side minus right side
    double overlap_max = 0;         // m, the deepest contact now
    double overlap_ratio_max = 0;   // -, deepest now, over the smaller radius
    double overlap_ratio_peak = 0;  // -, the largest overlap_ratio_max of any step so far
    double speed_max = 0;           // m/s
    double angular_speed_max = 0;   // rad/s
};

/// For checkpoints, base/archive.h.
template <class Archive, As<Books> B> void carry(Archive& archive, B& books) {
    auto& [time, step, bodies, contacts, kinetic_translation, kinetic_rotation, gravity, stored_normal,
           stored_tangential, stored_rolling, lost_normal_damping, lost_tangential_damping, lost_sliding, lost_rolling,
           lost_history, lost_global_damping, lost_air_drag, lost_adhesion, splits_losses, lost_in_sum, wall_work,
           inserted, closure, overlap_max, overlap_ratio_max, overlap_ratio_peak, speed_max, angular_speed_max] = books;
    archive(time, step, bodies, contacts, kinetic_translation, kinetic_rotation, gravity, stored_normal,
            stored_tangential, stored_rolling, lost_normal_damping, lost_tangential_damping, lost_sliding, lost_rolling,
            lost_history, lost_global_damping, lost_air_drag, lost_adhesion, splits_losses, lost_in_sum, wall_work,
            inserted, closure, overlap_max, overlap_ratio_max, overlap_ratio_peak, speed_max, angular_speed_max);
}

/// Energy lost so far, J.
inline double lost_of(const Books& b) {
    if (!b.splits_losses)
        return b.lost_in_sum;
    return b.lost_normal_damping + b.lost_tangential_damping + b.lost_sliding + b.lost_history + b.lost_global_damping +
           b.lost_rolling + b.lost_air_drag + b.lost_adhesion;
}

/// What the balance misses, J: everything there and lost, less everything put in.
inline double closure_of(const Books& b) {
    const double held = b.kinetic_translation + b.kinetic_rotation + b.gravity + b.stored_normal + b.stored_tangential +
                        b.stored_rolling;
    return held + lost_of(b) - b.inserted - b.wall_work;
}

} // namespace tumble
