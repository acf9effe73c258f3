#pragma once

#include "diagnose/decide.h"

#include <optional>
#include <string>
#include <vector>

namespace tumble::diagnose {

/// How far a residual goes along one direction, all that was fitted adjusted.
struct Along {
    double slope = 0,
           error = 0; // with its standard error, SI of the measure over that of the direction; NaN: not known
    double z = 0;     // standard errors
};

/// One direction of no particular cause, and what goes along it.
struct Fingerprint {
    std::string what;           // "the square of speed, with its sign (centre_of_mass_y)"
    std::string unit;           // of the slopes, as people write it
    bool of_condition = false;  // what would differ in one condition alone
    std::optional<Along> scene; // of what the baseline leaves; nothing: nuisances take it up
    std::optional<Along> best;  // of what the best explanation leaves; nothing: there is none, or it takes it up
};

/// Every direction of the evidence, in its order. Nothing where they have no names.
std::vector<Fingerprint> fingerprints_of(const Evidence& evidence, const Decision& decision);

/// How much of a cause's effect, nuisances adjusted, goes along one direction.
struct Likeness {
    std::size_t direction = 0; // as fingerprints_of() numbers them
    double share = 0;          // of the effect's square length: 1 is the same direction
};

/// The direction that is most like a cause's effect, the first of several that are the same; with `of_conditions` also
/// of those that would differ in one condition alone. Nothing where the cause does not act, or no direction is left.
std::optional<Likeness> likest(const Evidence& evidence, int cause, bool of_conditions = true);

} // namespace tumble::diagnose
