#pragma once

#include "observe/frame.h"

#include <string>

namespace tumble::observe {

/// The bytes of a binary STL file of the wall at its place, metres in single precision.
std::string stl_bytes(const FrameWall& wall, const WallPlace& place);

} // namespace tumble::observe
