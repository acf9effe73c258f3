#pragma once

#include "diagnose/diagnosis.h"

#include <string>
#include <vector>

namespace tumble::report {

/// How much the residual of a measure swings at each frequency, before and after, with the level that noise alone
/// seldom reaches. None where no record is long enough, or nothing was decided.
std::vector<std::string> spectrum_plots(const diagnose::Diagnosis& diagnosis, const std::string& measure,
                                        const std::string& head);

} // namespace tumble::report
