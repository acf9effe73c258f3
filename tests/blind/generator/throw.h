#pragma once

#include "lane.h"

namespace blind {

/// Where a ball was that is thrown at a plate.
struct Flight {
    Path along, height; // of its centre, m
};

/// A ball let go at 0 at `height` (m, of its centre) with that speed along the plate and no spin, until `duration`.
/// Impacts are those of `ball`; friction, rolling resistance and how the plate leans are those of `ground`. Flights:
/// Runge and Kutta's fourth order. Contacts, step by step at a fourteenth of the solver's: Hertz's spring and, across
/// it, Mindlin's without micro-slip under Coulomb's limit, both with dashpots as Tsuji, Tanaka and Ishida (1992) have
/// them; while it slides only the spring pulls.
Flight flight_of(const Ball& ball, const Lane& ground, double height, double speed, double duration);

} // namespace blind
