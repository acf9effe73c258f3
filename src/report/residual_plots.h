#pragma once

#include "diagnose/diagnosis.h"

#include <string>
#include <vector>

namespace tumble::report {

/// What a scene leaves unexplained of records, in standard errors: against time, speed and reading, and what the
/// extended scene leaves where there is one.
std::vector<std::string> residual_plots(const diagnose::Diagnosis& diagnosis);

/// The column's name without its unit: "way" of "way_mm".
std::string bare_head(const diagnose::Curve& curve);

/// What the second explanation in the pictures is: the extended scene, or the cause that comes nearest where none is
/// named.
std::string second_explanation(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
