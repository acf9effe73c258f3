#pragma once

#include "sim2d/world.h"

namespace tumble::sim2d {

/// What is not sane about the state after a step, if anything: a number that is not finite, a body that moves further
/// than its radius in a step, discs that overlap by more than a radius, a body that passed a wall or left the domain.
std::optional<Problem> insanity(const World& world);

} // namespace tumble::sim2d
