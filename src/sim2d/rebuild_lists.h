#pragma once

#include "sim2d/world.h"

namespace tumble::sim2d {

/// Makes the lists of neighbouring discs and of discs near walls anew: wraps bodies into the periodic box, now and then
/// sorts the slots by cell, cuts them into chunks, and carries the memory of every touching contact over.
void rebuild_lists(World& world);

} // namespace tumble::sim2d
