#pragma once

#include "diagnose/measurement.h"

namespace tumble::diagnose {

/// What the readings of one record contradict by themselves, without any simulation: a velocity whose sum is not the
/// way that was read beside it; an oscillation whose peak speed its amplitude and period cannot give; speeds beyond
/// what falls and walls of this scene give; a body that bounces higher than before though no wall moves; readings too
/// rare for how fast walls vibrate. `sigma`: SI, scatter of a reading, a channel each. One sentence each, with what to
/// do.
Problems kinematic_doubts(const Record& record, const std::vector<double>& sigma, const scene::Scene& scene);

} // namespace tumble::diagnose
