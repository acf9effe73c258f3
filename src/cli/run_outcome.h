#pragma once

#include "run/run_scene.h"

#include <string>

namespace tumble::cli {

/// "plays 4 times slower than life", for a video of so many seconds of watching per second of the run.
std::string video_pace(double slowdown);

/// What a run became, to stdout, as sentences or as JSON. Returns the exit code that goes with it.
int tell_outcome(const run::RunSummary& summary, bool json, bool quiet);

} // namespace tumble::cli
