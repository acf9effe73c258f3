#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// No body is given a leash longer than this many half skins.
constexpr double longest_leash = 3;

/// Makes the lists of neighbouring bodies and of bodies near walls anew: wraps bodies into the periodic box, sorts
/// the slots by cell, cuts them into chunks, and carries the memory of every touching contact over.
void rebuild_body_list(World& world);

} // namespace tumble::sim3d
