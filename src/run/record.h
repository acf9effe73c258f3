#pragma once

#include "base/problem.h"
#include "base/stop.h"
#include "observe/series.h"
#include "scene/scene.h"

namespace tumble::run {

/// Runs a scene in memory and gives what its [observe] names, about every observe.every seconds, and nothing else: no
/// folder, no frames. Problems: the scene cannot be built, a measure that does not exist, a state that stopped being
/// sane, a stop that is wanted.
///
/// A sphere alone among walls that stand still (flies_alone) is taken through its flights in strides of observe.every
/// and through its impacts in a whole number of steps, of about a quarter of the scene's: where in a step an impact
/// begins and ends would otherwise scatter what comes after by more than a camera resolves. Its impacts have rows of
/// their own, as close as they are short. On walls that move it takes a quarter of the scene's steps throughout. Where
/// a tracer follows it (docs/measures.md, "Tracers") it takes the scene's own steps, as everything else does.
Result<observe::Series> record(const scene::Scene& scene, int threads = 1, StopFlag stop = nullptr);

/// One sphere placed exactly, walls that do not move.
bool flies_alone(const scene::Scene& scene);

} // namespace tumble::run
