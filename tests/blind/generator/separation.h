#pragma once

#include "experiment.h"

namespace blind {

/// How far a case lies from what can be explained otherwise, in standard errors of its readings: noise-free readings of
/// the truth, everything innocent (restitution, clocks, speeds of throws) fitted anew, without and with each listed
/// rival. A rival, too, is that all clocks, or all speeds of throws, lie farther off than was said of them: what only
/// that says against is no effect that readings show. Errors have the memory that the setup says, and readings that
/// would be left out as slips count for nothing. A listed effect that one record alone shows, as a ceiling does that
/// only the highest drop reaches, is no more than an odd record: 0. All by the generator's own physics and Gauss and
/// Newton's method; nothing is linear in the amplitude.
struct Separation {
    double detectable = 0; // without any rival: d'
    double separable = 0;  // from the nearest rival: d'_sep, or d'_res of an unlisted effect
    std::string nearest;   // that rival
};

/// `without` is the truth less what was hidden, and where every explanation starts; `own`, the hidden effect's id, is
/// no rival of itself, nor is an effect that would be the same answer to these data. Clock offsets must be 0, so that
/// they cost nothing.
Separation separation_of(const Setup& setup, const Truth& truth, const Truth& without, const std::string& own);

/// The amplitude at which an effect is so separable, of the sign of `sign`; 0 where no amplitude that a laboratory
/// could overlook is.
double amplitude_for(const Setup& setup, const Truth& without, const Effect& effect, double wanted, double sign);

} // namespace blind
