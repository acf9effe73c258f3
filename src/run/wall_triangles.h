#pragma once

#include "observe/frame.h"
#include "scene/scene.h"

namespace tumble::run {

/// The wall's surface as triangles in its own, unmoved frame (m), for drawing and export. What goes on for ever is cut
/// at the domain: planes to the polygon inside it, boxes and troughs along periodic directions. Round things become 64
/// flat strips a turn. No triangles for a plane that misses the domain.
observe::FrameWall wall_triangles(const scene::Wall& wall, const scene::Domain& domain);

} // namespace tumble::run
