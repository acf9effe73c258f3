#pragma once

#include "observe/frame.h"

#include <string>

namespace tumble::observe {

/// One frame as LIGGGHTS and LAMMPS dump it ("ITEM: TIMESTEP" ...), one line per sphere: id type x y z radius vx vy vz
/// mol, SI, where type is 1 + shape and mol is 1 + body id. OVITO reads it. Frames may follow each other in one file.
std::string text_dump(const Frame& frame);

} // namespace tumble::observe
