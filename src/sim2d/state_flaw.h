#pragma once

#include "sim2d/world.h"

#include <string>

namespace tumble::sim2d {

/// What a state that was read cannot be, in words: counts that do not fit each other, an index that leads nowhere, a
/// position that is no number. Empty when a step can be taken from it.
std::string flaw_of(const World& world);

} // namespace tumble::sim2d
