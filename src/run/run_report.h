#pragma once

#include "run/run_folder.h"
#include "run/run_scene.h"

#include <nlohmann/json.hpp>
#include <string>

namespace tumble::run {

/// The content of run.json; the keys are stable and documented in docs/run-folder.md.
nlohmann::ordered_json to_json(const RunSummary& summary);

/// The content of a folder's run.json; empty where there is none that can be read.
nlohmann::json read_summary(const RunFolder& folder);

/// What this program is, as in run.json.
std::string version();

/// Processor and system of this machine, "AMD EPYC 9B14, 2 cores, Linux 6.1".
std::string host();

} // namespace tumble::run
