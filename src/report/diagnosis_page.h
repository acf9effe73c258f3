#pragma once

#include "diagnose/diagnosis.h"

#include <string>

namespace tumble::report {

/// A diagnosis as one HTML page that needs nothing beside it: verdict first, then what a reader can check by eye.
std::string page_of(const diagnose::Diagnosis& diagnosis, const std::string& version);

} // namespace tumble::report
