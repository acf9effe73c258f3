#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <array>
#include <string>
#include <vector>

/// Specimens: walls with an inside (docs/stress.md).
namespace tumble::scene {

/// As scenes write Held.
inline const std::vector<std::string> words_of_held{"base", "top", "both"};

/// With its mesh made. Problems carry the key to change.
Result<SpecimenShape> with_mesh(SpecimenShape specimen);

/// Its surface.
MeshShape mesh_of(const SpecimenShape& specimen);

/// Node sets of its mesh that do not move.
std::vector<std::string> held_sets(const SpecimenShape& specimen);

} // namespace tumble::scene
