#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// Why the last step's state must not be believed, or nothing: a number that is not finite, a body that crosses its own
/// smallest sphere's radius in one step, spheres that overlap by more than the smaller one's radius, a body outside the
/// domain. The problem names body, time and what to do.
std::optional<Problem> insanity(const World& world);

} // namespace tumble::sim3d
