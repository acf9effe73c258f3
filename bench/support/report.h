#pragma once

#include "sim3d/solver.h"

#include <cstdint>
#include <string>

namespace tumble::bench {

/// Takes `blocks` times `steps` steps and prints one JSON line for each:
/// {"block": name, "steps", "bodies", "seconds", "rate"}, rate in body-steps/s.
void timed_blocks(sim3d::World& world, const std::string& name, std::int64_t blocks, std::int64_t steps);

/// Prints {"phases": {name: s}, "steps", "bodies", "contacts", "closure_J", "booked_J", "overlap_ratio_max",
/// "kinetic_J", "peak_rss_MB"} as the last line; phases count from the world's start, booked is the largest energy
/// booked.
void print_summary(const sim3d::World& world);

} // namespace tumble::bench
