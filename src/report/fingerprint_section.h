#pragma once

#include "diagnose/diagnosis.h"

#include <string>

namespace tumble::report {

/// Why it looks like the causes that are suspected, and the table of everything the residual may follow: its slope
/// along each direction with standard error and a stamp, before and after. Empty where nothing was decided.
std::string fingerprint_section(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
