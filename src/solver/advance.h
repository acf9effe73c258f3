#pragma once

#include "base/problem.h"
#include "base/stop.h"

#include <cstdint>
#include <optional>

namespace tumble::solver {

/// Takes `steps` steps, inserting fills when they are due, until a step leaves a state that is not sane or a stop is
/// wanted. step(), insert_due_fills() and insanity() are those of the world's own solver.
template <class World> std::optional<Problem> advance(World& world, std::int64_t steps) {
    for (std::int64_t k = 0; k < steps; ++k) {
        if (world.step >= world.next_fill_step) {
            if (auto problem = insert_due_fills(world))
                return problem;
            if (stop_wanted(world.stop))
                return std::nullopt;
        }
        step(world);
        if (auto problem = insanity(world))
            return problem;
    }
    return std::nullopt;
}

} // namespace tumble::solver
