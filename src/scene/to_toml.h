#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <string>

namespace tumble::scene {

/// What a mesh file is called in the TOML, for files that were copied beside it.
using MeshNames = std::map<std::filesystem::path, std::string>;

/// The resolved scene as TOML that loads again to the same values, bit for bit, also where other defaults reign: every
/// key is written. Spheres of bodies and motions are written out; meshes have their name in `meshes`, else their
/// absolute path.
std::string to_toml(const Scene& scene, const MeshNames& meshes = {});

/// The motion's [[wall.motion]] tables, to stand below a wall.
std::string to_toml(const WallMotion& motion, int dimension);

} // namespace tumble::scene
