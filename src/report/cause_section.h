#pragma once

#include "diagnose/diagnosis.h"

#include <string>

namespace tumble::report {

/// How far each cause explains the misfit: bars, the longest first, with gate and margin; what does next to nothing is
/// summed up in words. Empty where nothing was decided.
std::string cause_section(const diagnose::Diagnosis& diagnosis);

/// The matrix of what these data can tell apart; empty where no cause shows.
std::string isolability_section(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
