#pragma once

#include "scene/scene.h"

#include <string>

namespace tumble::scene {

/// The resolved scene as TOML that loads again to the same values, bit for bit. It stands alone: spheres of bodies and
/// motions are written out, meshes are named by absolute path.
std::string to_toml(const Scene& scene);

} // namespace tumble::scene
