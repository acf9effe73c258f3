#pragma once

#include <cstdint>

namespace tumble::solver {

// How well the state of a step ago is known: up to roundings, of which the largest are those of an overlap between
// places that are given by far longer coordinates.
constexpr double slack = 1e-8;

/// What a contact's spring is stretched by, for a law that is asked once more about a step that it has answered. What
/// slid stands at the limit, give or take the slack, and at nothing where the limit was 0: a little further it slides
/// again.
inline double nudged(double stretch) {
    return stretch == 0 ? 1e-120 : stretch * (1 + slack);
}

/// Bodies that were inserted last, all before one step: their first, in which half a kick starts leapfrog.
struct Newcomers {
    std::int64_t first_id = 0;
    std::int64_t step = -1;

    void add(std::int64_t id, std::int64_t now) {
        if (step != now)
            *this = {id, now};
    }
    /// The share of a kick that the body got in the step before `now`.
    [[nodiscard]] double kick_before(std::int64_t id, std::int64_t now) const {
        return now == step + 1 && id >= first_id ? 0.5 : 1.0;
    }
};

} // namespace tumble::solver
