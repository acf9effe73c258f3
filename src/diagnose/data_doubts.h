#pragma once

#include "diagnose/measurement.h"

namespace tumble::diagnose {

/// What the readings of a record show without any simulation: gaps and jitter in time, clipping, coarse steps, scatter
/// that is not stated. One sentence each, with what to do.
void doubt_record(const Record& record, Problems& warnings);

/// Columns that hold the same numbers as another one: a copy was stored under two names, and no verdict can be built on
/// either. Records of held clocks ("time") may agree.
Problems equal_columns(const std::vector<Record>& records);

} // namespace tumble::diagnose
