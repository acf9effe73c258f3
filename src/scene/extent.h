#pragma once

#include "scene/scene.h"

#include <array>

namespace tumble::scene {

/// The box around a wall where it stands at rest, m; infinite along directions that it has no end in.
Box extent_of(const WallShape& shape);

/// The same for a wall of a scene of that dimension; flat at z = 0 in two.
Box extent_of(const Wall& wall, int dimension);

Box widened(const Box& box, double by);

/// The domain and around it as much as the wall's motion can take the wall in the run: what is outside of it at rest
/// stays outside of the domain.
Box reached_domain(const Wall& wall, const Scene& scene);

/// Whether any point of the triangle lies in the box, by the separating axes of both (Akenine-Moeller 2001).
bool overlap(const std::array<Vector3d, 3>& triangle, const Box& box);

} // namespace tumble::scene
