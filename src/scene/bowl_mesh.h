#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <optional>

/// Rotary bowls as triangles: one sheet without holes, each inner edge shared by two triangles, docs/bowl.md. Facets
/// and the sides of ribs are exactly flat, so that a body meets as few edges as there are.
namespace tumble::scene {

/// Facets of a round wall are no wider than this, degrees; at 0.17 m a facet then lies 0.1 mm inside the circle.
constexpr double widest_facet_deg = 4;

/// The first thing that cannot be built, with its key's name.
std::optional<Problem> fault_of(const BowlShape& shape);
std::optional<Problem> fault_of(const BowlDiscShape& shape);

/// Of a shape without fault.
MeshShape mesh_of(const BowlShape& shape);
MeshShape mesh_of(const BowlDiscShape& shape);

} // namespace tumble::scene
