#pragma once

#include "scene/time_step.h"
#include "sim2d/solver.h"

#include <vector>

namespace tumble::sim2d {

/// The scene's time scales with these bodies. For two free discs on one spring the limit is 2 / omega with omega^2 =
/// k / m*, taken for contacts that share a body (docs/bodies.md); Cundall and Strack 1979 take a fraction of
/// 2 sqrt(m / k).
scene::TimeStepReport time_step_report(const scene::Scene& scene, const std::vector<BodyShape>& shapes);

} // namespace tumble::sim2d
