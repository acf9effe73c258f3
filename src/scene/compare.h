#pragma once

#include "base/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// A key whose value differs between two scenes.
struct Change {
    std::string path;   // "material.glass.density_kg_m3", "wall.drum.motion.0.speed_rad_s"
    std::string before; // as TOML; empty: not there
    std::string now;
};

/// Every key that differs between two scenes as TOML, in the order of the first, then those that only the second has.
/// Problems: one of them is no TOML.
Result<std::vector<Change>> changes_between(std::string_view before, std::string_view now);

} // namespace tumble::scene
