#pragma once

#include "diagnose/decide.h"
#include "diagnose/fit.h"

namespace tumble::diagnose {

/// Between which an amplitude lies.
struct Limits {
    double low = 0, high = 0;
    bool linear = false; // one of them is taken from slopes: the simulation gave none
};

/// Of each cause of a fit beside that baseline, how far its amplitude may go to either side until chi-square, all else
/// adjusted, has risen by `reach` squared: 1.96 gives 95 %. What else is free follows its slopes; the simulation is
/// asked at the amplitude itself, so that limits of what is in no proportion to its amplitude need not lie alike to
/// both sides. The end of the plausible range where chi-square does not rise so far; the linear limit where that cannot
/// be simulated. None of causes that were not fitted.
std::vector<Limits> profile_of(const Refit& fitted, const Fit& baseline, Model& model, const Noise& noise,
                               double reach);

} // namespace tumble::diagnose
