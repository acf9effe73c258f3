#pragma once

#include "diagnose/diagnosis.h"

namespace tumble::report {

/// A bed's numbers, condition by condition: measured beside the baseline and the extended scene, with their scatter.
std::string bed_section(const diagnose::Diagnosis& diagnosis);

/// A number's intervals on one axis, as svg_of() draws them.
std::string plot_of(const diagnose::BedNumber& one);

std::string bed_small_print(const diagnose::Diagnosis& diagnosis, const std::string& warnings,
                            const std::string& version);

} // namespace tumble::report
