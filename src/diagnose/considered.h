#pragma once

#include "diagnose/cause.h"
#include "diagnose/measurement.h"

#include <set>
#include <string>

namespace tumble::diagnose {

/// The sensors that read these records; of columns that name none, "".
std::set<std::string> sensors_of(const std::vector<Record>& records);

/// The causes that a measurement of records asks for, without those that need measures which no record has; where
/// several sensors read, those of the instrument once for each. Ranges that go with the readings are set by them.
/// Problems: such a cause was asked for by name.
Result<std::vector<Cause>> considered_in(const Measurement& measurement);

} // namespace tumble::diagnose
