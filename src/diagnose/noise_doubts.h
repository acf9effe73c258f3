#pragma once

#include "diagnose/noise.h"
#include "diagnose/swings.h"

namespace tumble::diagnose {

/// What a reader of the verdict should know of its readings' scatter: that it is not as stated, that errors last, that
/// repeats differ, that lone readings were left out. One sentence each; `file` is the measurement's.
void doubt_noise(const NoiseReport& noise, const Model& model, const std::filesystem::path& file, Problems& warnings);

/// Readings without sigma that hardly scatter: no verdict can be built on them. Nothing: there are none.
std::optional<Problem> simulated_readings(const Noise& found, const Model& model);

/// That readings swing with the mains, where a residual (whitened) does.
void doubt_hum(const VectorXd& residual, const std::vector<Course>& courses, const std::filesystem::path& file,
               Problems& warnings);

} // namespace tumble::diagnose
