#pragma once

#include "diagnose/measurement.h"

#include <Eigen/Core>
#include <optional>

namespace tumble::diagnose {

/// What the readings of a record show without any simulation: gaps and jitter in time, clipping, coarse steps, scatter
/// that is not stated, columns that should read the same and do not. One sentence each, with what to do.
void doubt_record(const Record& record, Problems& warnings);

/// Series over time with the same sets whose readings differ by far more than they scatter.
void doubt_repeats(const std::vector<Record>& records, Problems& warnings);

/// A record that lasts so long beside the scene, s, that its time cannot be in seconds; or begins so late that it
/// cannot count from the scene's beginning. One that lasts less than a hundredth of the scene is a warning.
std::optional<Problem> time_slip(const Record& record, double scene_lasts, Problems& warnings);

/// Readings that were lost and written as a number of their own, such as 0 or -999: three or more that are equal, and
/// farther from their neighbours to both sides than twice any step between other readings, and ten times the scatter.
Problems lost_readings(const std::vector<Record>& records);

/// Columns that hold the same numbers as another one: a copy was stored under two names, and no verdict can be built on
/// either. Records of held clocks ("time") may agree.
Problems equal_columns(const std::vector<Record>& records);

/// A factor that units are usually wrong by.
bool usual_slip(double ratio);

/// Columns whose scale differs from what was foretold by one of the usual slips of units: no effect to be diagnosed. A
/// factor that a scene may be wrong by, such as ten, is a warning only.
Problems unit_slips(const std::vector<Record>& records, const Eigen::VectorXd& predicted, Problems& warnings);

} // namespace tumble::diagnose
