#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// Makes the lists of neighbouring bodies and of bodies near walls anew: wraps bodies into the periodic box, sorts
/// the slots by cell, cuts them into chunks, and carries the memory of every touching contact over.
void rebuild_lists(World& world);

} // namespace tumble::sim3d
