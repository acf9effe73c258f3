#pragma once

#include "experiment.h"

namespace blind {

/// The scene of a bench, in scenes/, and what one of its records is called.
std::string scene_of_bench(Bench bench);
std::string record_word(Bench bench);

/// A measurement's TOML: what was done to which file, by a laboratory that knows no more than the scene.
std::string measurement_of(const Setup& setup, const std::vector<std::string>& files, const Truth& known);

} // namespace blind
