#pragma once

#include "run/run_scene.h"

namespace tumble::cli {

/// What a run became, to stdout, as sentences or as JSON. Returns the exit code that goes with it.
int tell_outcome(const run::RunSummary& summary, bool json, bool quiet);

} // namespace tumble::cli
