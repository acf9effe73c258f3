#pragma once

#include "base/problem.h"
#include "observe/series.h"
#include "scene/scene.h"

namespace tumble::run {

/// Runs a scene in memory and gives what its [observe] names, every observe.every seconds, and nothing else: no folder,
/// no frames. Problems: the scene cannot be built, a measure that does not exist, a state that stopped being sane.
Result<observe::Series> record(const scene::Scene& scene, int threads = 1);

} // namespace tumble::run
