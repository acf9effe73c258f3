#pragma once

#include "diagnose/misread.h"

#include <Eigen/Core>
#include <optional>

namespace tumble::diagnose {

/// What the readings of a record show without any simulation: gaps and jitter in time, clipping, coarse steps, scatter
/// that is not stated, columns that should read the same and do not. One sentence each, with what to do.
void doubt_record(const Record& record, Problems& warnings);

/// A record that lasts so long beside the scene, s, that its time cannot be in seconds; or begins so late that it
/// cannot count from the scene's beginning.
std::optional<Problem> time_slip(const Record& record, double scene_lasts);

/// Readings that were lost and written as a number that stands for none, 0, -1 or nines: three or more that are equal,
/// and farther from their neighbours to both sides than twice any step between other readings, and ten times the
/// scatter. A place, in m, may begin or end with them.
Problems lost_readings(const std::vector<Record>& records);

/// Columns that hold the same numbers as another one: a copy was stored under two names, and no verdict can be built on
/// either. Records of held clocks ("time") may agree.
Problems equal_columns(const std::vector<Record>& records);

/// A factor that units are usually wrong by.
bool usual_slip(double ratio);

/// Columns whose scale differs from what was foretold by one of the usual slips of units: no effect to be diagnosed.
/// A factor that a scene may be wrong by, such as ten, is added to `misread`; records that are told there are passed
/// over.
Problems unit_slips(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                    std::vector<Misread>& misread);

} // namespace tumble::diagnose
