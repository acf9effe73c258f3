#pragma once

#include "base/problem.h"
#include "contact/material.h"
#include "scene/scene.h"
#include "sim3d/solver.h"

#include <Eigen/Core>
#include <vector>

namespace tumble::sim3d {

/// A template as the solver uses it: mass, centre and inertia of the union of its spheres (docs/bodies.md), spheres
/// moved to the centre of mass and turned into the principal frame. Axes: as written where the written ones are
/// principal already (off-diagonals below 1e-6 of the largest moment), else the nearest to the written ones,
/// right-handed. A single sphere gets 2/5 m r^2 and no turn. A mass given in the template scales the inertia; a given
/// principal inertia (kg m2, about the axes nearest to the written x, y, z) replaces it. Problems: no spheres, a radius
/// or a density that is not positive, a number that is not finite, an inertia that no body can have,
/// or that is far from any of that mass and size.
Result<BodyShape> make_body_shape(const scene::BodyTemplate& body, const contact::Material& material);

/// Indices, ascending, into shape.spheres of the spheres that can ever touch anything from outside: without those whose
/// whole surface lies inside others. Exact up to rounding, and a doubtful sphere stays in.
std::vector<int> contact_spheres(const BodyShape& shape);

} // namespace tumble::sim3d
