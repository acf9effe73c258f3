#pragma once

#include "diagnose/diagnosis.h"

#include <nlohmann/json.hpp>
#include <string>

namespace tumble::report {

/// All of a diagnosis but its curves, with stable keys; docs/diagnosis.md explains each. `version` is the program's.
nlohmann::ordered_json to_json(const diagnose::Diagnosis& diagnosis, const std::string& version);

/// The curves: time, reading, baseline, extended, and both residuals in standard errors, one row a reading.
std::string residuals_csv(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
