#pragma once

#include "base/problem.h"
#include "sim2d/world.h"

#include <optional>
#include <string_view>

namespace tumble::sim2d {

/// Puts a saved state into a prepared world that has no bodies yet. After a problem the world is of no use.
std::optional<Problem> restore(World& world, std::string_view state);

} // namespace tumble::sim2d
