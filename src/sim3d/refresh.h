#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// Finds anew which spheres of the pair may touch before the two have travelled the sphere skin together, or, when none
/// is that near, how far they may travel before anyone must look again. Touching spheres keep their memory.
void refresh(const World& world, Chunk& chunk, BodyPair& pair);

/// The same for a body and a wall.
void refresh(const World& world, Chunk& chunk, BodyWall& near);

/// Centre of a body's exposed sphere relative to its centre of mass, world frame, m.
Eigen::Vector3d sphere_arm(const World& world, int slot, int exposed);

} // namespace tumble::sim3d
