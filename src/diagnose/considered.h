#pragma once

#include "diagnose/cause.h"
#include "diagnose/measurement.h"

namespace tumble::diagnose {

/// The causes that a measurement of records asks for, without those that need measures which no record has; ranges that
/// go with the readings are set by them. Problems: such a cause was asked for by name.
Result<std::vector<Cause>> considered_in(const Measurement& measurement);

} // namespace tumble::diagnose
