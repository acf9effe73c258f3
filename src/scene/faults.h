#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <optional>

/// What can be neither simulated nor drawn, whether a file asks for it or code builds it. The key of a problem is the
/// one to change, in its own table. Bowls have theirs in bowl_mesh.h.
namespace tumble::scene {

/// Laws that do not go together in scenes of that dimension.
Problems faults_of(const ContactLaws& laws, int dimension);

/// Principal moments, kg m2, that no body has.
std::optional<Problem> fault_of_inertia(const Vector3d& moments);

std::optional<Problem> fault_of(const BoxShape& shape);
std::optional<Problem> fault_of(const DiscShape& shape);
std::optional<Problem> fault_of(const TroughShape& shape);

} // namespace tumble::scene
