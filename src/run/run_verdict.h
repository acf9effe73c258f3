#pragma once

#include "run/run_scene.h"

namespace tumble::run {

/// What passed through the books, J: kinetic, stored and lost energy.
double turned_over(const Books& books);

/// What a run showed that its user should know, a sentence each: bodies that found no room, overlaps beyond what the
/// scene expects, an energy balance that does not close.
std::vector<std::string> verdict(const RunSummary& summary, const scene::Scene& scene);

} // namespace tumble::run
