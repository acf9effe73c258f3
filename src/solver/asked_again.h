#pragma once

namespace tumble::solver {

// How well the state of a step ago is known: of single spheres and discs up to roundings; where clumps touch, whose
// parts go round their centres of mass meanwhile, to first order in the step.
constexpr double single_slack = 1e-9;
constexpr double clump_slack = 1e-4;

/// What a contact's spring is stretched by, for a law that is asked once more about a step that it has answered. What
/// slid stands at the limit, give or take the slack, and at nothing where the limit was 0: a little further it slides
/// again.
inline double nudged(double stretch, double slack) {
    return stretch == 0 ? 1e-120 : stretch * (1 + slack);
}

} // namespace tumble::solver
