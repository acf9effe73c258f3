#pragma once

#include "diagnose/decide.h"

#include <optional>
#include <string>

namespace tumble::diagnose {

/// What would have to be fitted besides for the data to be explained where no cause does.
struct Besides {
    std::string what{}; // a nuisance, or "the zero of centre_of_mass_y"
    double gain = 0;    // fall of chi-square
    int numbers = 0;    // by which it is fitted
    double p = 0;       // adequacy of what is then left
    std::string most{}; // of what differs between conditions: the one that explains most alone
};

/// Something that would have to differ from condition to condition: no one cause, but experiments that are not alike
/// ("het.condition"). The one that explains most and leaves only noise, if there is one and it explains more than
/// chance would.
std::optional<Besides> differing_in(const Evidence& evidence, const Settings& settings);

/// A nuisance that would have to be less well known beforehand than was said, found like that.
std::optional<Besides> overstated_in(const Evidence& evidence, const Settings& settings);

/// Causes whose readings that nuisance gives, too: nobody sees which it is.
std::vector<std::string> alike_to(const Evidence& evidence, const std::string& nuisance);

} // namespace tumble::diagnose
