#pragma once

#include "diagnose/diagnosis.h"

#include <string>

namespace tumble::report {

/// Records beside what the scene gives, then the residual of every column, before and after. Says what is left out.
std::string record_section(const diagnose::Diagnosis& diagnosis);

/// Of each column the scatter that was stated and that was found, and how neighbours correlate.
std::string scatter_table(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
