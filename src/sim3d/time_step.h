#pragma once

#include "scene/time_step.h"
#include "sim3d/solver.h"

#include <vector>

namespace tumble::sim3d {

using scene::TimeStepReport;

/// The scene's time scales with these bodies.
scene::TimeStepReport time_step_report(const scene::Scene& scene, const std::vector<BodyShape>& shapes);

} // namespace tumble::sim3d
