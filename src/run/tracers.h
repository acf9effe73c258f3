#pragma once

#include "base/problem.h"
#include "observe/tracer.h"
#include "run/simulation.h"
#include "scene/scene.h"

/// Words "tracer:BODY" among the measures of a scene: each follows the first body of that name.
namespace tumble::run {

/// The other words.
std::vector<std::string> without_tracers(const std::vector<std::string>& measures);

/// Names of the bodies that the words follow, in their order.
std::vector<std::string> traced_bodies(const std::vector<std::string>& measures);

/// Bodies that the scene does not have, with the key, but no place yet.
Problems check_tracers(const scene::Scene& scene);

/// Readers in the order written. Problems: check_tracers.
Result<std::vector<observe::TracerReader>> tracers_of(const scene::Scene& scene,
                                                      const std::vector<SimulatedBody>& bodies);

} // namespace tumble::run
