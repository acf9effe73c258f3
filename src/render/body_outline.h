#pragma once

#include "render/drawing.h"

#include <vector>

namespace tumble::render {

/// The outline of all that the discs cover together, circles with their arcs left out (pixels): loops of arcs, holes
/// among them. A disc inside another is not seen.
std::vector<std::vector<Arc>> outline_of(const std::vector<Arc>& discs);

} // namespace tumble::render
