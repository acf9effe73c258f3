#pragma once

#include "diagnose/decide.h"

#include <optional>
#include <string>

namespace tumble::diagnose {

/// Something that would have to differ from condition to condition for the data to be explained: no one cause, but
/// experiments that are not alike ("het.condition").
struct Differing {
    std::string what{}; // a nuisance, or "the zero of centre_of_mass_y"
    double gain = 0;    // fall of chi-square
    int numbers = 0;    // by which it is fitted
    double p = 0;       // adequacy of what is then left
};

/// The one that explains most and leaves only noise, if there is one and it explains more than chance would.
std::optional<Differing> differing_in(const Evidence& evidence, const Settings& settings);

} // namespace tumble::diagnose
