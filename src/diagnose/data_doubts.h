#pragma once

#include "diagnose/measurement.h"
#include "diagnose/signal.h"

#include <Eigen/Core>
#include <optional>

namespace tumble::diagnose {

/// What the readings of a record show without any simulation: gaps and jitter in time, clipping, coarse steps, scatter
/// that is not stated, columns that should read the same and do not. One sentence each, with what to do.
void doubt_record(const Record& record, Problems& warnings);

/// A record that lasts so long beside the scene, s, that its time cannot be in seconds; or begins so late that it
/// cannot count from the scene's beginning.
std::optional<Problem> time_slip(const Record& record, double scene_lasts);

/// A record that misses what was foretold (`truth`, a signal for each channel) by ten times its scatter (`sigma`, SI)
/// and agrees five times as well, or better, if its time is shifted by a tenth of its length or more: it does not count
/// from the scene's beginning.
std::optional<Problem> shifted_time(const Record& record, const std::vector<Signal>& truth,
                                    const std::vector<double>& sigma);

/// Columns that hold the same numbers as another one: a copy was stored under two names, and no verdict can be built on
/// either. Records of held clocks ("time") may agree.
Problems equal_columns(const std::vector<Record>& records);

/// Columns whose scale differs from what was foretold by one of the usual slips of units: no effect to be diagnosed. A
/// factor that a scene may be wrong by, such as ten, is a warning only.
Problems unit_slips(const std::vector<Record>& records, const Eigen::VectorXd& predicted, Problems& warnings);

/// Heights of a sphere that lie a radius, m, below what was foretold of its centre, in the middle of all of them: those
/// of its lowest point, no effect to be diagnosed.
std::optional<Problem> lowest_point(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                                    double radius);

} // namespace tumble::diagnose
