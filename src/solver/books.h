#pragma once

#include "base/books.h"
#include "solver/kernels.h"

#include <cstdint>

namespace tumble::solver {

/// What a step did, J and extremes: of one chunk, or of all.
struct Sums {
    ContactSums contacts;
    double lost_air_drag = 0;
    MotionSums motion;

    void add(const Sums& more);
};

/// Running sums, J. Losses are sums of force * velocity * dt at the steps; the books take the last one half.
struct Ledger {
    double lost_normal_damping = 0;
    double lost_tangential_damping = 0;
    double lost_sliding = 0;
    double lost_rolling = 0;
    double lost_air_drag = 0;
    double lost_adhesion = 0;
    double lost_history = 0;
    double lost_global_damping = 0;
    double wall_work = 0;
    double inserted = 0;
    double overlap_ratio_peak = 0; // -
};

/// Adds step number `step` (the first is 1), of `dt` s, to the ledger and gives the account of the instant at which it
/// began.
Books book_step(Ledger& ledger, const Sums& now, std::int64_t step, double dt, std::int64_t bodies);

/// The same for a world, which lets its time pass. Chunks are added up in their order.
template <class World> void book_step(World& world) {
    Sums now;
    for (const auto& chunk : world.chunks)
        now.add(chunk.sums);
    ++world.step;
    world.books = book_step(world.ledger, now, world.step, world.dt, world.bodies());
}

} // namespace tumble::solver
