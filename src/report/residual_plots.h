#pragma once

#include "diagnose/diagnosis.h"

#include <string>
#include <vector>

namespace tumble::report {

/// What a scene leaves unexplained of records, in standard errors: against time, speed and reading, and what the
/// extended scene leaves where there is one.
std::vector<std::string> residual_plots(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
